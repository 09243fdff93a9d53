// marrow.js in a worker: waits for the compiled program, runs no app, and does what it is asked to.
// Linked before all else into marrow.js.
if (typeof importScripts === 'function') {
  Module['noInitialRun'] = true;
  let compiled, run;
  const isCompiled = new Promise((resolve) => { compiled = resolve; });
  const runs = new Promise((resolve) => { run = resolve; });
  const fail = () => postMessage({failed: true});
  Module['instantiateWasm'] = (imports, receive) => {
    isCompiled.then((module) => WebAssembly.instantiate(module, imports))
        .then((instance) => receive(instance))
        .catch(fail);
    return {};
  };
  Module['onRuntimeInitialized'] = run;
  const work = async (request) => {
    await runs;
    const size = lengthBytesUTF8(request) + 1, address = _malloc(size);
    if (!address) throw new RangeError('no memory left');
    stringToUTF8(request, address, size);
    _marrow_work(address);
    _free(address);
  };
  onmessage = ({data}) => {
    if (data.request === undefined) return data.module ? compiled(data.module) : fail();
    work(data.request).catch(fail);
  };
}
