// What is kept by itself: found again after a reload, a crash and a closed tab, and never mixed up
// between two tabs.
import assert from 'node:assert/strict';

import {App, circle, closed, dense, test} from './harness.mjs';

const ring = (x, y, radius) => dense(closed(circle(x, y, radius)), 10);

/// Another tab of the same browser.
async function tab(app) {
  const page = await app.page.context().newPage();
  const other = new App(page, await page.context().newCDPSession(page), app.address, app.label);
  await other.open();
  return other;
}

const entries = (app) => app.page.evaluate(() => new Promise((resolve, reject) => {
  const request = indexedDB.open('marrow', 1);
  request.onerror = () => reject(request.error);
  request.onsuccess = () => {
    const all = request.result.transaction('slots').objectStore('slots').getAll();
    all.onsuccess = () => { request.result.close(); resolve(all.result); };
  };
}));

/// Waits until so many drawings with these numbers of parts are kept.
async function kept(app, ...parts) {
  const wanted = JSON.stringify([...parts].sort());
  for (let i = 0; i < 100; ++i) {
    const found = JSON.stringify((await entries(app)).map((one) => one.parts).sort());
    if (found === wanted) return;
    await app.page.waitForTimeout(50);
  }
  assert.fail(`kept: ${JSON.stringify(await entries(app))}, wanted: ${wanted}`);
}

const offered = (app) => app.until(() => marrow.stats().drawing.offered !== null);
async function reload(app) {
  await app.page.reload();
  await app.ready();
}

test('a drawing is offered after a reload, and gone on with', async (app) => {
  await app.draw(ring(500, 350, 120));
  await app.draw(ring(800, 350, 80));
  const before = await app.document();
  await kept(app, 2);
  await reload(app);
  await offered(app);
  await app.settled();
  await app.screenshot('offer');
  assert.deepEqual(await app.parts(), [], 'nothing comes by itself');
  await app.press('offer', 'open');
  await app.until(() => marrow.parts().length === 2);
  assert.equal(await app.document(), before);
  await app.settled();
  assert.equal((await app.stats()).drawing.offered, null);

  // It goes on in its own place, however often.
  await app.draw(ring(640, 600, 60));
  await kept(app, 3);
  await reload(app);
  await offered(app);
  await app.press('offer', 'open');
  await app.until(() => marrow.parts().length === 3);
  assert.equal((await entries(app)).length, 1);
});

test('what was drawn in the last second is not lost either', async (app) => {
  await app.draw(ring(500, 350, 120));
  await reload(app);
  await offered(app);
  await app.press('offer', 'open');
  await app.until(() => marrow.parts().length === 1);
});

test('a drawing is offered after a crash and after the tab was closed', async (app) => {
  await app.draw(ring(500, 350, 120));
  await kept(app, 1);
  const crashed = new Promise((done) => app.page.once('crash', done));
  app.session.send('Page.crash').catch(() => {});
  await crashed;
  let other = await tab(app);
  await offered(other);
  await other.press('offer', 'open');
  await other.until(() => marrow.parts().length === 1);
  await other.draw(ring(800, 350, 80));
  await kept(other, 2);
  await other.page.close({runBeforeUnload: true});
  other = await tab(app);
  await offered(other);
  await other.press('offer', 'open');
  await other.until(() => marrow.parts().length === 2);
});

test('two tabs keep their own drawings', async (app) => {
  await app.draw(ring(500, 350, 120));
  await kept(app, 1);
  const other = await tab(app);
  await other.page.waitForTimeout(300);
  assert.equal((await other.stats()).drawing.offered, null, 'a drawing that is open is not offered');
  await other.draw(ring(500, 350, 120));
  await other.draw(ring(800, 350, 80));
  await kept(app, 1, 2);
  await app.page.bringToFront();
  await app.draw(ring(800, 350, 80));
  await app.draw(ring(640, 600, 60));
  await kept(app, 2, 3);
  await other.page.close();
  await reload(app);
  await app.until(() => marrow.stats().drawing.recent.length === 2);
  const parts = (await app.stats()).drawing.recent.map((one) => one.parts);
  assert.deepEqual(parts.sort(), [2, 3]);
});

test('the offer blocks nobody, and what was declined waits among the recent drawings', async (app) => {
  await app.draw(ring(500, 350, 120));
  await app.press('toolbar', 'file');
  const {x, y} = await app.widget('file', 'name');
  await app.click(x, y);
  await app.page.keyboard.type('Snail');
  await app.key('Enter');
  await app.press('file', 'close');
  await kept(app, 1);
  await reload(app);
  await offered(app);
  await app.draw(ring(800, 500, 80));
  assert.equal((await app.stats()).drawing.offered, null, 'drawing goes on without an answer');
  assert.equal((await app.stats()).widgets.some((one) => one.panel === 'offer'), false);
  await kept(app, 1, 1);

  await app.press('toolbar', 'file');
  await app.until(() => marrow.stats().drawing.recent.length === 1);
  await app.until(() => marrow.stats().drawing.thumbnails.some((one) => one.ready));
  await app.settled();
  await app.screenshot('recent');
  assert.equal((await app.stats()).drawing.recent[0].name, 'Snail');
  await app.press('file', 'recent');
  await app.until(() => marrow.stats().drawing.name === 'Snail');
  await app.settled();
  await app.key('Control+z');
  assert.equal((await app.stats()).drawing.name, '', 'undo: the drawing before');
  assert.equal((await app.parts()).length, 1);

  // Declined: not offered again, but not gone.
  await reload(app);
  await offered(app);
  await app.press('offer', 'not now');
  await app.until(() => marrow.stats().drawing.offered === null);
  await app.page.waitForTimeout(300);
  await reload(app);
  await app.until(() => marrow.stats().drawing.recent.length === 2);
  assert.equal((await app.stats()).drawing.offered, null);
});

test('a new drawing leaves the one before among the recent ones', async (app) => {
  await app.draw(ring(500, 350, 120));
  await app.press('toolbar', 'file');
  await app.press('file', 'new');
  await kept(app, 1);
  await app.press('toolbar', 'file');
  await app.until(() => marrow.stats().drawing.recent.length === 1);
  await app.settled();
  await app.press('file', 'recent');
  await app.until(() => marrow.parts().length === 1);
  await app.settled();
  await app.draw(ring(800, 350, 80));
  await kept(app, 2);
});

test('ten drawings are kept, the newest ones', async (app) => {
  for (let i = 0; i < 12; ++i) {
    await app.page.evaluate((n) => marrow.load({format: 'marrow', version: 1, title: `number ${n}`,
      parts: [{stroke: {points: [[0, 0], [100, 0], [0, 100]]}}]}), i);
    await app.settled();
  }
  await reload(app);
  await app.until(() => marrow.stats().drawing.recent.length === 10);
  await app.settled();
  const names = (await app.stats()).drawing.recent.map((one) => one.name);
  assert.equal(new Set(names).size, 10);
  assert.ok(!names.includes('number 0') && !names.includes('number 1'), names.join());
});

test('where nothing can be kept it is said, once', {init: () => {
  Object.defineProperty(window, 'indexedDB', {get() { throw new DOMException('no', 'SecurityError'); }});
  Object.defineProperty(window, 'localStorage', {get() { throw new DOMException('no', 'SecurityError'); }});
}}, async (app) => {
  await app.draw(ring(500, 350, 120));
  await app.until(() => /keeps nothing/.test(marrow.stats().message));
  await app.until(() => marrow.stats().message === null);
  await app.draw(ring(800, 350, 80));
  await app.page.waitForTimeout(1500);
  assert.doesNotMatch((await app.stats()).message ?? '', /keeps nothing/);
});

test('a full storage is said in a sentence, and nothing is lost on the canvas', {init: () => {
  IDBObjectStore.prototype.put = () => { throw new DOMException('full', 'QuotaExceededError'); };
  Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); };
}}, async (app) => {
  await app.draw(ring(500, 350, 120));
  await app.until(() => /no room|keeps nothing/.test(marrow.stats().message));
  assert.equal((await app.parts()).length, 1);
});
