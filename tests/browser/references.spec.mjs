// Pictures to draw after: behind the strokes of one view, kept in the document.
import assert from 'node:assert/strict';
import {createRequire} from 'node:module';
import {readFile} from 'node:fs/promises';

import {differing, test} from './harness.mjs';

const {PNG} = createRequire(import.meta.url)('pngjs');

/// A picture whose left half is red and whose right half is blue.
function halves(width, height) {
  const image = new PNG({width, height});
  for (let i = 0; i < width * height; ++i) {
    const left = i % width < width / 2;
    image.data.set(left ? [220, 30, 30, 255] : [30, 30, 220, 255], 4 * i);
  }
  return PNG.sync.write(image);
}
const isRed = ([r, g, b]) => r - Math.max(g, b) > 40 && Math.abs(g - b) < 25;
const isBlue = ([r, g, b]) => b - Math.max(r, g) > 40;

async function give(app, kind, name, type, bytes) {
  await app.page.evaluate(({kind, name, type, base64}) => {
    const transfer = new DataTransfer();
    const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    transfer.items.add(new File([data], name, {type}));
    const canvas = document.getElementById('canvas');
    const options = {bubbles: true, cancelable: true};
    canvas.dispatchEvent(kind === 'paste'
        ? new ClipboardEvent('paste', {...options, clipboardData: transfer})
        : new DragEvent('drop', {...options, dataTransfer: transfer}));
  }, {kind, name, type, base64: Buffer.from(bytes).toString('base64')});
}
const ready = (app, count) => app.until((n) => {
  const {drawing} = marrow.stats();
  return marrow.document().references?.length === n &&
      drawing.pictures.every((one) => one === 'ready');
}, count).then(() => app.settled());
const references = (app) => app.page.evaluate(() => marrow.document().references ?? []);
const plain = () => { delete window.showSaveFilePicker; delete window.showOpenFilePicker; };

test('a picture lies behind the strokes of its view, and is saved and undone', {init: plain},
     async (app) => {
  const empty = await app.document();
  await give(app, 'drop', 'halves.png', 'image/png', halves(400, 300));
  await ready(app, 1);
  await app.screenshot('laptop');
  const [reference] = await references(app);
  assert.equal(reference.view, 'front');
  assert.match(reference.image, /^data:image\/png;base64,/);
  let image = await app.pixels();
  assert.ok(isRed(image.at(560, 400)) && isBlue(image.at(720, 400)), 'left is left');

  // Strokes are drawn on it as ever.
  await app.draw([[560, 300], [720, 300], [720, 480], [560, 480], [560, 300]].flatMap(
      ([x, y], i, all) => i === 0 ? [[x, y]] : Array.from({length: 16}, (_, k) => [
        all[i - 1][0] + (x - all[i - 1][0]) * (k + 1) / 16,
        all[i - 1][1] + (y - all[i - 1][1]) * (k + 1) / 16])));
  assert.equal((await app.parts()).length, 1);
  image = await app.pixels();
  assert.ok(!isRed(image.at(600, 400)), 'the part hides it');
  await app.screenshot('drawn');

  // From elsewhere it is not seen.
  const box = [300, 150, 980, 700];
  assert.ok(image.find(isRed, box).count > 50_000);
  await app.key('3');
  assert.ok((await app.pixels()).find(isRed, box).count < 500, 'an outline is as red at most');
  await app.key('1');
  assert.ok((await app.pixels()).find(isRed, box).count > 50_000);

  // One per view.
  await app.key('7');
  await give(app, 'paste', 'image.png', 'image/png', halves(64, 64));
  await ready(app, 2);
  assert.deepEqual((await references(app)).map((one) => one.view), ['front', 'top']);
  await give(app, 'paste', 'image.png', 'image/png', halves(32, 64));
  await app.until(() => marrow.stats().drawing.pictures.length === 3);
  await ready(app, 2);
  await app.key('1');

  // Saved, opened, the same.
  const whole = await app.document();
  const [download] = await Promise.all([app.page.waitForEvent('download'),
                                        app.page.keyboard.press('Control+s')]);
  const text = await readFile(await download.path(), 'utf8');
  await app.press('toolbar', 'new');
  assert.ok((await app.pixels()).find(isRed, box).count < 500);
  await app.page.evaluate((json) => marrow.load(json), text);
  await ready(app, 2);
  assert.deepEqual(JSON.parse(await app.document()).references, JSON.parse(whole).references);
  assert.ok((await app.pixels()).find(isRed, box).count > 50_000);

  while (await app.page.evaluate(() => marrow.undo())) ;
  assert.equal(await app.document(), empty);
  await app.settled();
  assert.ok((await app.pixels()).find(isRed, box).count < 500);
});

test('its sliders and buttons change it, and all of it is undone', async (app) => {
  await give(app, 'drop', 'halves.png', 'image/png', halves(400, 300));
  await ready(app, 1);
  const [fit] = await references(app);
  const drag = async (id, by) => {
    const {x, y} = await app.widget('picture', id);
    await app.drag([x, y], [x + by, y]);
    return (await references(app))[0];
  };
  assert.ok((await drag('opacity', 60)).opacity > 0.6);
  const strong = await app.pixels();
  await app.key('Control+z');
  assert.deepEqual(await references(app), [fit]);
  assert.ok(differing(strong, await app.pixels()) > 10000);
  assert.ok((await drag('size', -60)).scale < 0.7 * fit.scale);
  const moved = await drag('across', 60);
  assert.ok(moved.position[0] > 50);
  assert.ok((await drag('upright', -40)).position[1] < -20);
  await app.press('picture', 'fit');
  const [again] = await references(app);
  assert.ok(Math.abs(again.scale / fit.scale - 1) < 1e-9);
  assert.deepEqual(again.position, fit.position);
  await app.press('picture', 'remove');
  assert.deepEqual(await references(app), []);
  await app.key('Control+z');
  assert.deepEqual(await references(app), [again]);
});

test('what is no picture is said in a sentence, and a large one is made smaller', async (app) => {
  const before = await app.document();
  for (const [name, type] of [['note.png', 'image/png'], ['photo.jpg', 'image/jpeg']]) {
    await give(app, 'drop', name, type, Buffer.from('this is no picture'));
    await app.until((file) => marrow.stats().message?.startsWith(file), name);
    assert.match((await app.stats()).message, /^\S+ cannot be shown: [^.]+\.$/);
    assert.equal(await app.document(), before);
  }
  await give(app, 'drop', 'wide.png', 'image/png', halves(5000, 200));
  await ready(app, 1);
  const [{image}] = await references(app);
  const size = await app.page.evaluate(async (address) => {
    const picture = new Image();
    picture.src = address;
    await picture.decode();
    return [picture.naturalWidth, picture.naturalHeight];
  }, image);
  assert.deepEqual(size, [2048, 82]);

  // A drawing with a damaged picture opens all the same.
  await app.page.evaluate(() => marrow.load({format: 'marrow', version: 1, parts: [],
    references: [{view: 'front', image: 'data:image/png;base64,AAAA'}]}));
  await app.until(() => marrow.stats().drawing.pictures.includes('broken'));
});

test('on a phone the picture has a sheet of its own', {width: 360, height: 740, scale: 2, touch: true},
     async (app) => {
  await app.press('lower bar', 'view');
  await app.screenshot('phone-view');
  await app.press('view sheet', 'picture');
  await app.screenshot('phone-none');
  const [chooser] = await Promise.all([app.page.waitForEvent('filechooser'),
                                       app.press('picture', 'choose')]);
  await chooser.setFiles({name: 'halves.png', mimeType: 'image/png', buffer: halves(300, 400)});
  await ready(app, 1);
  await app.screenshot('phone');
  const {x, y, width, height} = await app.widget('picture', 'remove');
  const isGround = ([r, g, b]) => r > 200 && r < 245 && Math.abs(r - g) < 12 && Math.abs(r - b) < 12;
  const box = [x - width / 2 + 8, y - height / 2 + 4, x + width / 2 - 8, y + height / 2 - 4];
  assert.ok((await app.pixels()).find(isGround, box).count > 1000, 'the sheet shows its last row');
  await app.press('picture', 'close');
  await app.screenshot('phone-closed');
  const image = await app.pixels();
  assert.ok(isRed(image.at(120, 380)) && isBlue(image.at(240, 380)));
});
