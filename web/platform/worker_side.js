// marrow.js in a worker: waits for the compiled program, runs no app, and does what it is asked to.
// Linked before all else into marrow.js.
if (typeof importScripts === 'function') {
  Module['noInitialRun'] = true;
  let compiled, run;
  const isCompiled = new Promise((resolve) => { compiled = resolve; });
  const runs = new Promise((resolve) => { run = resolve; });
  Module['instantiateWasm'] = (imports, receive) => {
    isCompiled.then((module) => WebAssembly.instantiate(module, imports))
        .then((instance) => receive(instance));
    return {};
  };
  Module['onRuntimeInitialized'] = run;
  onmessage = async ({data}) => {
    if (data.module) return compiled(data.module);
    await runs;
    const size = lengthBytesUTF8(data.request) + 1, address = _malloc(size);
    stringToUTF8(data.request, address, size);
    _marrow_work(address);
    _free(address);
  };
}
