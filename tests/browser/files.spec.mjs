// Drawings in files: saved and opened by the controls, the keys and the hand of a user.
import assert from 'node:assert/strict';
import {writeFile} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {circle, closed, dense, test} from './harness.mjs';

const ring = (x, y, radius) => dense(closed(circle(x, y, radius)), 10);
/// A browser that cannot write to the user's own files.
const plain = {init: () => {
  delete window.showSaveFilePicker;
  delete window.showOpenFilePicker;
}};

const drawing = (name, ...strokes) => JSON.stringify({
  format: 'marrow', version: 1, title: name,
  parts: strokes.map((points) => ({stroke: {points}})), mine: {kept: [1, 2]},
});
const square = [[0, 0], [100, 0], [100, 100], [0, 100]];

/// Does something that downloads a file; its name and its text.
async function downloaded(app, act) {
  const {name, bytes} = await app.downloaded(act);
  return {name, text: bytes.toString()};
}

/// Does something that asks for a file, and chooses one with this text.
async function choose(app, name, text, act) {
  const file = join(tmpdir(), `${process.pid}-${name}`);
  await writeFile(file, text);
  const [chooser] = await Promise.all([app.page.waitForEvent('filechooser'), act()]);
  await chooser.setFiles({name, mimeType: 'application/json', buffer: Buffer.from(text)});
  await app.settled();
}

/// Drops files on the canvas.
export async function drop(app, files) {
  await app.page.evaluate((all) => {
    const transfer = new DataTransfer();
    for (const {name, type, base64} of all) {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      transfer.items.add(new File([bytes], name, {type}));
    }
    const canvas = document.getElementById('canvas');
    for (const kind of ['dragenter', 'dragover', 'drop']) {
      canvas.dispatchEvent(new DragEvent(kind, {bubbles: true, cancelable: true,
                                                dataTransfer: transfer}));
    }
  }, files);
}
const dropText = (app, name, text) =>
    drop(app, [{name, type: 'application/json', base64: Buffer.from(text).toString('base64')}]);

const opened = (app, parts) =>
    app.until((n) => marrow.parts().length === n, parts).then(() => app.settled());

test('a drawing is saved, changed, and opened again as it was', plain, async (app) => {
  assert.equal(await app.page.title(), 'Marrow');
  await app.draw(ring(500, 350, 120));
  assert.equal(await app.page.title(), '• Untitled – Marrow');
  const first = await downloaded(app, () => app.page.keyboard.press('Control+s'));
  assert.equal(first.name, 'Untitled.json');
  assert.equal(await app.page.title(), 'Untitled – Marrow');
  assert.match((await app.stats()).message, /Untitled\.json/);

  await app.draw(ring(800, 350, 80));
  const two = await app.document();
  assert.equal(await app.page.title(), '• Untitled – Marrow');
  await app.key('Control+z');
  assert.equal(await app.page.title(), 'Untitled – Marrow', 'undone: nothing has changed');
  await app.key('Control+Shift+z');
  const second = await downloaded(app, () => app.page.keyboard.press('Control+Shift+s'));
  assert.equal(JSON.parse(second.text).parts.length, 2);

  await choose(app, 'my first.json', first.text, () => app.page.keyboard.press('Control+o'));
  await opened(app, 1);
  assert.equal(await app.page.title(), 'my first – Marrow');
  const parts = (text) => JSON.stringify(JSON.parse(text).parts);
  assert.equal(parts(await app.document()), parts(first.text));

  // Opening is a step like any other, and the drawing before it has its own name.
  await app.key('Control+z');
  assert.equal(await app.document(), two);
  assert.equal(await app.page.title(), 'Untitled – Marrow');
  await app.key('Control+Shift+z');
  assert.equal(await app.page.title(), 'my first – Marrow');
});

test('the sheet offers the same, and a name', plain, async (app) => {
  await app.draw(ring(500, 350, 120));
  await app.press('toolbar', 'file');
  await app.screenshot('sheet');
  const {x, y} = await app.widget('file', 'name');
  await app.click(x, y);
  await app.page.keyboard.type('My "best" cat/dog');
  await app.key('Enter');
  assert.equal(await app.page.title(), '• My "best" cat/dog – Marrow');
  const {name, text} = await downloaded(app, () => app.press('file', 'save'));
  assert.equal(name, 'My -best- cat-dog.json');
  assert.equal(JSON.parse(text).format, 'marrow');
  await choose(app, 'other.json', drawing('Two', square, square.map(([a, b]) => [a + 300, b])),
               () => app.press('file', 'open'));
  await opened(app, 2);
  assert.equal((await app.stats()).widgets.filter((one) => one.panel === 'file').length, 0);

  await app.press('toolbar', 'file');
  await app.press('file', 'new');
  assert.deepEqual(await app.parts(), []);
  assert.equal(await app.page.title(), 'Marrow');
  await app.key('Control+z');
  assert.equal((await app.parts()).length, 2);
  assert.equal(await app.page.title(), 'other – Marrow');
});

test('a dropped file is opened, and fields that nobody knows are kept', plain, async (app) => {
  await dropText(app, 'strange.json', drawing('Strange', square));
  await opened(app, 1);
  assert.equal(await app.page.title(), 'strange – Marrow');
  const {text} = await downloaded(app, () => app.page.keyboard.press('Control+s'));
  assert.deepEqual(JSON.parse(text).mine, {kept: [1, 2]});
  assert.equal(JSON.parse(text).title, 'strange');
});

test('a broken or newer file is refused in one sentence and changes nothing', plain, async (app) => {
  await app.draw(ring(500, 350, 120));
  const [before, title] = [await app.document(), await app.page.title()];
  const whole = drawing('Whole', square);
  const cases = {
    'empty.json': '', 'half.json': whole.slice(0, -9), 'text.json': 'hello',
    'list.json': '[]', 'other.json': '{"format": "other"}',
    'newer.json': whole.replace('"version":1', '"version":2'),
    'points.json': whole.replace('[[0,0]', '[["a",0]'),
    'huge.json': whole.replace('[[0,0]', '[[1e999,0]'),
  };
  for (const [name, text] of Object.entries(cases)) {
    await app.page.evaluate(() => { window.before = marrow.stats().message; });
    await dropText(app, name, text);
    await app.until((file) => marrow.stats().message?.startsWith(file), name);
    const {message} = await app.stats();
    assert.match(message, /^\S+\.json cannot be opened: \S.{6,120}\.$/, name);
    assert.equal(message.split(/[.!?] /).length, 1, `one sentence: ${message}`);
    if (name === 'newer.json') assert.match(message, /newer version/);
    assert.equal(await app.document(), before, name);
    assert.equal(await app.page.title(), title);
  }
  await app.screenshot('refused');
  const stats = await app.stats();
  assert.equal(stats.drawing.changed, true);
});

test('where the browser can, saving writes to the same file', {init: () => {
  // A browser's own dialogs cannot be pressed by a test: these answer at once.
  const files = window.files = {};
  const handle = (name) => ({
    name, kind: 'file',
    getFile: async () => new File([files[name]], name, {type: 'application/json'}),
    createWritable: async () => {
      if (window.refuse) throw new DOMException('no', 'NotAllowedError');
      let text = '';
      return {write: async (more) => { text += more; }, close: async () => { files[name] = text; }};
    },
  });
  window.asked = [];
  window.showSaveFilePicker = async (options) => {
    window.asked.push(options.suggestedName);
    if (!window.answer) throw new DOMException('', 'AbortError');
    return handle(window.answer);
  };
  window.showOpenFilePicker = async () => [handle(window.answer)];
}}, async (app) => {
  const answer = (name) => app.page.evaluate((file) => { window.answer = file; }, name);
  const file = (name) => app.page.evaluate((one) => files[one], name);
  const asked = () => app.page.evaluate(() => asked);
  await app.draw(ring(500, 350, 120));

  // Thought better of it: nothing happens, nothing is said.
  await app.key('Control+s');
  assert.equal((await app.stats()).drawing.changed, true);
  assert.equal((await app.stats()).message, null);

  await answer('ring.json');
  await app.key('Control+s');
  await app.until(() => window.files['ring.json']);
  assert.deepEqual(await asked(), ['Untitled.json', 'Untitled.json']);
  await app.until(() => document.title === 'ring – Marrow');

  await app.draw(ring(800, 350, 80));
  await app.until(() => document.title === '• ring – Marrow');
  await app.key('Control+s');
  await app.until(() => JSON.parse(window.files['ring.json']).parts.length === 2);
  assert.equal((await asked()).length, 2, 'it is not asked again');

  // Another drawing is opened, and undoing that brings back where the first one belongs.
  await app.page.evaluate((text) => { window.files['square.json'] = text; }, drawing('', square));
  await answer('square.json');
  await app.key('Control+o');
  await opened(app, 1);
  assert.equal(await app.page.title(), 'square – Marrow');
  await app.key('Control+z');
  await app.draw(ring(640, 600, 60));
  await app.key('Control+s');
  await app.until(() => JSON.parse(window.files['ring.json']).parts.length === 3);
  assert.equal(JSON.parse(await file('square.json')).parts.length, 1, 'the other file is untouched');

  await answer('copy.json');
  await app.key('Control+Shift+s');
  await app.until(() => window.files['copy.json']);
  await app.until(() => document.title === 'copy – Marrow');

  await app.page.evaluate(() => { window.refuse = true; });
  await app.draw(ring(300, 600, 60));
  await app.key('Control+s');
  await app.until(() => /copy\.json was not saved/.test(marrow.stats().message));
  assert.equal((await app.stats()).drawing.changed, true);
});
