// The panels of the selected parts and of all parts: each control does what it says, and undo takes
// it back by name.
import assert from 'node:assert/strict';

import {circle, closed, dense, test} from './harness.mjs';

const ring = (x, y, radius) => dense(closed(circle(x, y, radius)), 10);
const part = (app, index) => app.page.evaluate((i) => marrow.document().parts[i], index);
const phone = {width: 360, height: 740, touch: true};

async function undone(app, act) {
  const before = await app.document();
  await act();
  const after = await app.document();
  assert.notEqual(after, before);
  await app.key('Control+z');
  assert.equal(await app.document(), before, 'undone');
  await app.key('Control+Shift+z');
  assert.equal(await app.document(), after, 'redone');
}

/// A body and a head on it, with the head selected.
async function two(app) {
  await app.draw(ring(500, 450, 130));
  await app.key('m');
  await app.draw(ring(560, 330, 70));
  assert.equal((await app.parts()).length, 2);
  assert.equal((await app.stats()).selected, 'part-2');
}

test('depth by slider and by layers', async (app) => {
  await two(app);
  const depth = async () => (await part(app, 1)).frame.origin[2];
  const start = await depth();
  const slider = await app.widget('part', 'depth');
  await undone(app, () => app.drag([slider.x, slider.y], [slider.x + slider.width / 4, slider.y]));
  const near = await depth();
  assert.ok(near > start + 5, `${near} is nearer than ${start}`);
  await undone(app, () => app.press('part', 'layerDown'));
  assert.ok(await depth() < near);
  await undone(app, () => app.key(']'));
  assert.ok(await depth() > start);
  const before = await app.document();
  for (let i = 0; i < 4; ++i) await app.key(']');
  assert.match((await app.stats()).message, /front/);
  assert.ok(before.length > 0);
});

test('duplicate, hide, lock and delete', async (app) => {
  await two(app);
  await undone(app, () => app.press('part', 'duplicate'));
  assert.equal((await app.parts()).length, 3);
  await app.key('Control+z');
  await app.click(560, 300);
  await undone(app, () => app.press('part', 'hide'));
  assert.equal((await part(app, 1)).visible, false);
  await undone(app, () => app.press('part', 'hide'));
  await undone(app, () => app.press('part', 'lock'));
  assert.equal((await part(app, 1)).locked, true);
  await undone(app, () => app.press('part', 'lock'));
  await undone(app, () => app.press('part', 'delete'));
  assert.equal((await app.parts()).length, 1);
});

test('twins come, follow and are parted', async (app) => {
  await two(app);
  await undone(app, () => app.press('part', 'twin'));
  assert.ok((await part(app, 1)).mirror);
  await app.screenshot('twins');
  await undone(app, () => app.press('part', 'separate'));
  assert.deepEqual((await app.parts()).length, 3);
});

test('several parts share one panel', async (app) => {
  await two(app);
  await app.key('Control+a');
  await app.screenshot('several');
  await undone(app, () => app.press('part', 'color', 4));
  assert.equal((await part(app, 0)).color, (await part(app, 1)).color);
  const {x, y, width} = await app.widget('part', 'thickness');
  await undone(app, () => app.drag([x, y], [x + width / 4, y]));
  assert.equal((await part(app, 0)).thickness, (await part(app, 1)).thickness);
  assert.ok((await part(app, 0)).thickness > 1.3);
});

test('where a part hangs can be overruled', async (app) => {
  await two(app);
  await app.press('part', 'attachment');
  await app.screenshot('hangs');
  await undone(app, () => app.press('part', 'detach'));
  assert.equal((await part(app, 1)).attachment.part, '');
  await app.screenshot('detached');
  await app.press('part', 'attach');
  await app.screenshot('attaching');
  await undone(app, () => app.click(470, 500));
  assert.equal((await part(app, 1)).attachment.part, 'part-1');
  assert.equal((await app.stats()).selected, 'part-2', 'still selected');
  await undone(app, () => app.press('part', 'root'));
  assert.equal((await part(app, 1)).root, true);
  await undone(app, () => app.press('part', 'byItself'));
  assert.equal((await part(app, 1)).attachment, undefined);
  await app.press('part', 'attach');
  await app.key('Escape');
  assert.equal((await app.stats()).selected, 'part-2', 'Esc ends the question alone');
});

test('a part without bones moves with what it sits on', async (app) => {
  await two(app);
  await app.press('part', 'skeleton');
  await undone(app, () => app.press('part', 'bones'));
  assert.equal((await part(app, 1)).skeleton, false);
  await app.screenshot('no-bones');
});

test('the list shows all parts, selects, hides and locks', async (app) => {
  await two(app);
  await app.draw(ring(900, 650, 40));
  await app.press('switches', 'parts');
  await app.screenshot('list');
  await app.press('parts', 'row', 0);
  assert.deepEqual((await app.stats()).selection, ['part-1']);
  const second = await app.widget('parts', 'row', 1);
  await app.page.keyboard.down('Shift');
  await app.click(second.x, second.y);
  assert.deepEqual((await app.stats()).selection, ['part-1', 'part-2']);
  await app.click(second.x, second.y);
  assert.deepEqual((await app.stats()).selection, ['part-1']);
  await app.page.keyboard.up('Shift');
  await undone(app, () => app.press('parts', 'visible', 2));
  assert.equal((await part(app, 2)).visible, false);
  await undone(app, () => app.press('parts', 'locked', 1));
  assert.equal((await part(app, 1)).locked, true);
  await app.press('parts', 'row', 1);
  await app.screenshot('locked');
});

test('sixty parts scroll in the list', async (app) => {
  await app.page.evaluate(() => marrow.load({format: 'marrow', version: 1, parts:
    Array.from({length: 60}, (_, i) => ({
      name: `A part with a rather long name, number ${i + 1}`,
      stroke: {points: Array.from({length: 24}, (_, k) => [
        40 * Math.cos(k * Math.PI / 12), 30 * Math.sin(k * Math.PI / 12)])},
      frame: {origin: [60 * (i % 10), 50 * Math.floor(i / 10), 0], x: [1, 0, 0], y: [0, 1, 0]},
    }))}));
  await app.key('f');
  await app.press('switches', 'parts');
  const rows = async () => (await app.stats()).widgets.filter(({id}) => id === 'row').length;
  assert.ok(await rows() < 30, 'only what is seen is made');
  const row = await app.widget('parts', 'row', 2);
  await app.page.mouse.move(row.x, row.y);
  for (let i = 0; i < 30; ++i) await app.page.mouse.wheel(0, 400);
  await app.settled();
  await app.screenshot('sixty');
  await app.press('parts', 'row', (await rows()) - 1);
  assert.deepEqual((await app.stats()).selection, ['part-60']);
});

test('fingers scroll a sheet without moving its sliders', phone, async (app) => {
  await app.touch([ring(180, 300, 110)]);
  const tap = async (panel, id, index) => {
    const {x, y} = await app.widget(panel, id, index);
    await app.touch([[[x, y]]]);
  };
  await tap('lower bar', 'part');
  await app.screenshot('phone-part');
  const text = await app.document();
  const slider = await app.widget('part', 'depth');
  const finger = [[slider.x + 40, slider.y], [slider.x + 42, slider.y - 160]];
  await app.touch([dense(finger, 8)]);
  assert.equal(await app.document(), text, 'scrolling changes nothing');
  const after = await app.widget('part', 'depth').catch(() => null);
  assert.ok(!after || after.y < slider.y - 60, 'it scrolled');
  await tap('part', 'skeleton');
  await app.touch([dense(finger, 8)]);
  await app.screenshot('phone-scrolled');
  await tap('lower bar', 'part');
  await tap('lower bar', 'parts');
  await app.screenshot('phone-list');
  await tap('lower bar', 'parts');
  await tap('lower bar', 'view');
  await app.screenshot('phone-view');
  await tap('view sheet', 'skeleton');
  await app.screenshot('phone-skeleton');
});

test('no panel lies upon another', async (app) => {
  await two(app);
  await app.press('part', 'skeleton');
  await app.press('performance button', 'performance');
  const {widgets} = await app.stats();
  const left = Math.min(...widgets.filter(({panel}) => panel === 'part').map(({x}) => x));
  const close = widgets.find(({panel}) => panel === 'performance panel');
  assert.ok(close.x + close.width < left, 'beside the column');
  await app.screenshot('beside');
});

test('on a phone nothing covers what is to be tapped', phone, async (app) => {
  await app.touch([ring(180, 330, 90)]);
  await app.touch([ring(240, 250, 40)]);
  const tap = async (panel, id, index) => {
    const {x, y} = await app.widget(panel, id, index);
    await app.touch([[[x, y]]]);
  };
  await tap('lower bar', 'part');
  await app.touch([dense([[180, 640], [182, 330]], 8)]);
  await tap('part', 'skeleton');
  for (let i = 0; i < 2; ++i) await app.touch([dense([[180, 640], [182, 330]], 8)]);
  await tap('part', 'attachment');
  await app.touch([dense([[180, 640], [182, 330]], 8)]);
  await tap('part', 'attach');
  const panels = (await app.stats()).widgets.map(({panel}) => panel);
  assert.ok(!panels.includes('part') && !panels.includes('refine'), panels.join());
  await app.screenshot('phone-attaching');
  await app.touch([[[150, 380]]]);
  assert.equal((await part(app, 1)).attachment.part, 'part-1');
});

test('help can be read', async (app) => {
  await app.press('toolbar', 'help');
  await app.screenshot('help');
});

test('panels on a dense screen', {scale: 2, height: 720}, async (app) => {
  await two(app);
  await app.press('part', 'skeleton');
  await app.press('switches', 'parts');
  await app.screenshot('dense');
});
