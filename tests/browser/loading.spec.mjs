// From the page's first byte to the first stroke, and what is said where something is missing.
import assert from 'node:assert/strict';

import {test} from './harness.mjs';

const message = (app) => app.page.textContent('#message');

/// Lets go of a request that a test holds.
function held() {
  let release;
  const released = new Promise((done) => { release = done; });
  return {released, release};
}

const wasm = held();
test('the page says that it is getting ready, and then gives way to the canvas', {
  ready: false,
  async prepare(app) {
    await app.page.route('**/marrow.wasm', async (route) => {
      await wasm.released;
      await route.continue();
    });
  },
}, async (app) => {
  assert.match(await message(app), /Getting ready/);
  assert.equal(await app.page.locator('progress').isVisible(), true);
  await app.screenshot('loading');
  wasm.release();
  await app.ready();
  await app.until(() => getComputedStyle(document.getElementById('loading')).opacity === '0');
  const hit = await app.page.evaluate(() => document.elementFromPoint(innerWidth / 2,
                                                                      innerHeight / 2).id);
  assert.equal(hit, 'canvas');
  await app.settled();
  await app.screenshot('first-look');
  assert.equal(await app.page.evaluate(async () => await marrow.ready === marrow), true);
  assert.deepEqual(await app.parts(), []);

  // It asks nobody but its own site.
  const foreign = app.requests.filter((url) => !url.startsWith(app.address));
  assert.deepEqual(foreign, []);
  assert.ok(app.requests.some((url) => url.endsWith('/marrow.wasm')));
});

test('a file that does not arrive is said in a sentence', {
  ready: false,
  prepare: (app) => app.page.route('**/marrow.wasm', (route) => route.abort()),
}, async (app) => {
  await app.until(() => /could not be loaded/.test(document.getElementById('message').textContent));
  assert.equal(await app.page.evaluate(() => marrow.ready.catch((error) => error.message)),
               await message(app));
  app.errors.length = 0;  // the browser itself logs the request that failed
});

test('without WebGL 2 the page says so', {
  ready: false, width: 360, height: 640,
  init: () => {
    const getContext = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function(kind, ...rest) {
      return kind === 'webgl2' ? null : getContext.call(this, kind, ...rest);
    };
  },
}, async (app) => {
  await app.until(() => /WebGL 2/.test(document.getElementById('message').textContent));
  assert.match(await message(app), /does not offer it.*current browser/s);
  assert.equal(await app.page.locator('progress').isVisible(), false);
  assert.match(await app.page.evaluate(() => marrow.ready.catch((error) => error.message)), /WebGL/);
  await app.screenshot('no-webgl');
});

test('without WebAssembly the page says so', {
  ready: false, init: () => { delete window.WebAssembly; },
}, async (app) => {
  await app.until(() => /WebAssembly/.test(document.getElementById('message').textContent));
  assert.equal(await app.page.locator('#loading').isVisible(), true);
  assert.match(await app.page.evaluate(() => marrow.ready.catch((error) => error.message)),
               /WebAssembly/);
});
