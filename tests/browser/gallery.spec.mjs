// The samples: seen small, opened, played with, undone.
import assert from 'node:assert/strict';

import {circle, closed, dense, test} from './harness.mjs';

const ring = (x, y, radius) => dense(closed(circle(x, y, radius)), 10);
const cards = (app) => app.stats().then(({widgets}) =>
    widgets.filter((one) => one.panel === 'gallery' && one.id === 'sample'));
const shown = (app) => app.until(() => {
  const {widgets, drawing} = marrow.stats();
  const count = widgets.filter((one) => one.id === 'sample').length;
  return count > 0 && drawing.thumbnails.filter((one) => one.ready).length >= count;
}, undefined, 90_000).then(() => app.settled());

const isInk = (color) => Math.min(...color) < 190;

/// Every card within the canvas shows something.
async function checkCards(app) {
  const {width, height} = app.page.viewportSize();
  const image = await app.pixels();
  let checked = 0;
  for (const {x, y, width: w, height: h} of await cards(app)) {
    if (x < 0 || y < 0 || x + w > width || y + h > height * 0.9) continue;
    const found = image.find(isInk, [x + 4, y + 4, x + w - 4, y + h - 34]);
    assert.ok(found.count > 0.02 * w * h * image.scale ** 2, `nothing in the card at ${x}, ${y}`);
    ++checked;
  }
  assert.ok(checked >= 2);
}

test('every sample has its picture, opens, and is undone', {width: 1280, height: 800}, async (app) => {
  const {x, y} = await app.widget('start', 'samples');
  await app.page.mouse.click(x, y);
  await shown(app);
  await app.screenshot('laptop');
  const all = await cards(app);
  assert.ok(all.length >= 8, `${all.length} samples`);
  await checkCards(app);
  await app.press('gallery', 'close');

  await app.draw(ring(640, 400, 100));
  const own = await app.document();
  for (let i = 0; i < all.length; ++i) {
    await app.press('toolbar', 'file');
    await app.press('file', 'samples');
    const {y} = (await cards(app))[i];
    if (y > 700) {
      const panel = await app.widget('gallery', 'sample', 0);
      await app.page.mouse.move(panel.x, panel.y);
      await app.page.mouse.wheel(0, 2000);
      await app.settled();
    }
    await app.press('gallery', 'sample', i);
    await app.until(() => marrow.parts().length > 2);
    await app.settled();
    const {drawing, evaluation} = await app.stats();
    assert.ok(drawing.name.length > 1 && !drawing.changed, drawing.title);
    for (const part of await app.parts()) assert.equal(part.error, undefined, drawing.name);
    console.log(`        ${drawing.name}: ${evaluation.ms.toFixed(1)} ms`);
    await app.key('Control+z');
    assert.equal(await app.document(), own, 'the drawing before is back');
  }
});

test('on a phone the samples are two in a row, and one is a starting point',
     {width: 360, height: 740, scale: 2, touch: true}, async (app) => {
  await app.screenshot('phone-hint');
  const {x, y} = await app.widget('start', 'samples');
  await app.page.mouse.click(x, y);
  await shown(app);
  await app.screenshot('phone');
  await checkCards(app);
  const all = await cards(app);
  assert.equal(all[0].y, all[1].y);
  assert.notEqual(all[1].y, all[2].y);
  for (const {width} of all) assert.ok(width > 120);
  await app.press('gallery', 'sample', 0);
  await app.until(() => marrow.parts().length > 2);
  await app.settled();
  await app.screenshot('phone-opened');
  const before = (await app.parts()).length;
  await app.draw(ring(180, 160, 40));
  assert.equal((await app.parts()).length, before + 1);
  assert.equal((await app.stats()).drawing.changed, true);
});
