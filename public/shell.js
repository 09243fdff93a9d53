// Loads the app: shows how far it is, says what is missing, and gives window.marrow.ready.
'use strict';

window.marrow = {};
let markReady, markFailed;
window.marrow.ready = new Promise((resolve, reject) => {
  markReady = resolve;
  markFailed = reject;
});
window.marrow.ready.catch(() => {});

function whenPageIsThere(then) {
  if (document.readyState !== 'loading') return then();
  document.addEventListener('DOMContentLoaded', then);
}

function fail(sentence) {
  markFailed(new Error(sentence));
  whenPageIsThere(() => {
    document.getElementById('loading').className = '';
    document.getElementById('message').textContent = sentence;
    document.getElementById('progress').hidden = true;
  });
}

function whatIsMissing() {
  if (typeof WebAssembly !== 'object') {
    return 'This browser has no WebAssembly, which Marrow needs. ' +
        'A current version of any browser has it.';
  }
  const probe = document.createElement('canvas').getContext('webgl2');
  if (!probe) {
    return 'Marrow draws with WebGL 2, and this browser does not offer it. Please try a current ' +
        'browser, or switch on hardware acceleration in its settings.';
  }
  const release = probe.getExtension('WEBGL_lose_context');
  if (release) release.loseContext();
  return '';
}

// The response, telling how much of it has arrived.
function withProgress(response, total) {
  const reader = response.body.getReader();
  let received = 0;
  const stream = new ReadableStream({
    async pull(controller) {
      const {done, value} = await reader.read();
      if (done) return controller.close();
      received += value.length;
      const bar = document.getElementById('progress');
      if (bar) bar.value = Math.min(1, received / total);
      controller.enqueue(value);
    },
  });
  return new Response(stream, {headers: {'Content-Type': 'application/wasm'}});
}

async function instantiate(imports, receive) {
  const response = await wasm;
  if (!response.ok) throw new Error(String(response.status));
  const total = Number(response.headers.get('Content-Length')) || 3e6;
  const result = await WebAssembly.instantiateStreaming(withProgress(response, total), imports);
  receive(result.instance, result.module);
}

const missing = whatIsMissing();
const wasm = missing ? null : fetch('marrow.wasm', {credentials: 'same-origin'});
const broken = 'Marrow could not be loaded. Please check the connection and load the page again.';

var Module = {
  noInitialRun: Boolean(missing),
  instantiateWasm(imports, receive) {
    if (!missing) instantiate(imports, receive).catch(() => fail(broken));
    return {};
  },
  preRun: [() => { Module.canvas = document.getElementById('canvas'); }],
  onReady() {
    document.getElementById('loading').className = 'done';
    document.getElementById('canvas').focus({preventScroll: true});
    markReady(window.marrow);
  },
  onAbort() { fail('Marrow has stopped. Please load the page again.'); },
};

if (missing) fail(missing);
window.addEventListener('error', (event) => {
  if (event.target.tagName === 'SCRIPT') fail(broken);
}, true);
