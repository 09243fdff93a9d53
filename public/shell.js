// Loads the app: shows how far it is, says what is missing, and gives window.marrow.ready.
'use strict';

const sentences = {
  wasm: 'This browser has no WebAssembly, which Marrow needs. A current version of any browser has it.',
  webgl: 'Marrow draws with WebGL 2, and this browser does not offer it. Please try a current ' +
      'browser, or switch on hardware acceleration in its settings.',
  old: 'This browser is too old for Marrow. A current version of any browser will do.',
  broken: 'Marrow could not be loaded. Please check the connection and load the page again.',
  stopped: 'Marrow has stopped. Please load the page again.',
};

window.marrow = {};
let markReady, markFailed, failed = false;
window.marrow.ready = new Promise((resolve, reject) => {
  markReady = resolve;
  markFailed = reject;
});
window.marrow.ready.catch(() => {});

const pageIsThere = new Promise((resolve) => {
  if (document.readyState !== 'loading') resolve();
  document.addEventListener('DOMContentLoaded', resolve);
});

async function fail(sentence) {
  if (failed) return;
  failed = true;
  markFailed(new Error(sentence));
  await pageIsThere;
  document.getElementById('loading').className = '';
  document.getElementById('message').textContent = sentence;
  document.getElementById('progress').hidden = true;
}

// The response, telling how much of it has arrived.
function withProgress(response) {
  const total = Number(response.headers.get('Content-Length')) || 1e6;
  const bar = document.getElementById('progress');
  const reader = response.body.getReader();
  let received = 0;
  const stream = new ReadableStream({
    async pull(controller) {
      const chunk = await reader.read();
      if (chunk.done) return controller.close();
      received += chunk.value.length;
      bar.value = Math.min(1, received / total);
      controller.enqueue(chunk.value);
    },
  });
  return new Response(stream, {headers: {'Content-Type': 'application/wasm'}});
}

async function instantiate(imports, receive) {
  const response = await download;
  await pageIsThere;
  if (!response.ok) throw new Error(String(response.status));
  const result = WebAssembly.instantiateStreaming
      ? await WebAssembly.instantiateStreaming(withProgress(response), imports)
      : await WebAssembly.instantiate(await withProgress(response).arrayBuffer(), imports);
  Module.compiled = result.module;  // for workers
  if (!failed) receive(result.instance, result.module);
}

const hasWasm = typeof WebAssembly === 'object';
const download = hasWasm ? fetch('marrow.wasm', {credentials: 'same-origin'}) : null;
if (!hasWasm) fail(sentences.wasm);

var Module = {
  instantiateWasm(imports, receive) {
    if (!hasWasm) return {};
    instantiate(imports, receive).catch((error) => {
      fail(error instanceof WebAssembly.CompileError ? sentences.old : sentences.broken);
    });
    return {};
  },
  onReady() {
    document.getElementById('loading').className = 'done';
    Module.canvas.focus({preventScroll: true});
    markReady(window.marrow);
  },
  onAbort() { fail(sentences.stopped); },
};

// Without WebAssembly the script itself would stop with an error that nobody understands.
if (hasWasm) {
  const script = document.createElement('script');
  script.src = 'marrow.js';
  script.onerror = () => fail(sentences.broken);
  document.head.appendChild(script);
}

pageIsThere.then(() => {
  const canvas = Module.canvas = document.getElementById('canvas');
  canvas.width = Math.round(canvas.clientWidth * devicePixelRatio);
  canvas.height = Math.round(canvas.clientHeight * devicePixelRatio);
  // The app asks for the same context again and gets this one.
  const context = canvas.getContext('webgl2', {alpha: false, antialias: true, depth: true});
  if (!context) fail(sentences.webgl);
});
