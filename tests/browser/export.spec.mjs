// The character taken away as a file, by hand: from an empty canvas to a posed GLB that three.js
// moves as we do; every format, and what happens while a file is made.
import assert from 'node:assert/strict';
import {readFile} from 'node:fs/promises';
import {join} from 'node:path';

import {checkJoints, heightOf, load, validate, worstVertex} from '../node/gltf.mjs';
import {drawDog} from './dog.mjs';
import {root, test} from './harness.mjs';
import {apart, openPosing, poses, posing, pull, ready} from './posing.mjs';

/// A browser that cannot write to the user's own files.
const plain = {init: () => {
  delete window.showSaveFilePicker;
}};

/// The first workers get a broken program, until `heal` is called.
const sick = {init: () => {
  delete window.showSaveFilePicker;
  const Healthy = window.Worker;
  window.Worker = class extends Healthy {
    postMessage(message) {
      super.postMessage(message.module ? {module: 'broken'} : message);
    }
  };
  window.heal = () => { window.Worker = Healthy; };
}};

const exporting = async (app) => (await app.stats()).export;
const has = async (app, panel, id) =>
    (await app.stats()).widgets.some((one) => one.panel === panel && one.id === id);

async function openSheet(app) {
  await app.press('toolbar', 'file');
  if (!await has(app, 'file', 'export')) {  // a low canvas
    const {x, y} = await app.widget('file', 'new');
    await app.page.mouse.move(x, y);
    await app.page.mouse.wheel(0, 150);
    await app.settled();
  }
  await app.press('file', 'export');
}
/// A press right after a button has taken another's place was meant for the other.
const later = (app) => app.page.waitForTimeout(600);
const save = async (app) => {
  await later(app);
  return app.downloaded(() => app.press('export', 'save'));
};

/// The figure as the page has it posed: vertices, and triangles as indices.
async function posed(app) {
  const {positions, triangles} = await app.page.evaluate(() => {
    const {positions: all, triangles: some} = marrow.posed();
    return {positions: [...all], triangles: [...some]};
  });
  const vertices = [];
  for (let i = 0; i < positions.length; i += 3) vertices.push(positions.slice(i, i + 3));
  return {vertices, triangles};
}

const indices = ({meshes}) => meshes.map((mesh) => [...mesh.geometry.index.array]);

test('from an empty canvas to a posed GLB in under two minutes', plain, async (app) => {
  const start = Date.now();
  await drawDog(app);
  await app.key('p');
  await ready(app);
  const ends = await app.page.evaluate(() => {
    const {joints} = marrow.rig();
    const isEnd = ({id}) => !joints.some(({parent}) => parent === id);
    const end = (part, k, sign) => joints.filter((joint) => joint.part === part && isEnd(joint))
        .sort((a, b) => sign * (a.position[k] - b.position[k]))[0].name;
    return {paw: end('part-2', 1, 1), hind: end('part-3:twin', 1, 1), tail: end('part-5', 1, -1),
            head: end('part-4', 0, 1)};
  });
  await pull(app, ends.tail, [-40, -50]);
  await pull(app, ends.paw, [-70, -60]);
  await pull(app, ends.hind, [40, -20]);
  await app.screenshot('posed-dog');
  const {pose} = await posing(app);
  assert.equal((await poses(app)).length, 1);
  await app.press('pose', 'export');
  await app.screenshot('posed-dog-sheet');
  const {name, bytes} = await save(app);
  const took_s = (Date.now() - start) / 1000;
  assert.ok(took_s < 120, `${took_s} s`);
  assert.equal(name, 'Untitled.glb');
  assert.match((await app.stats()).message, /Untitled\.glb/);

  await validate('dog', bytes);
  const loaded = await load(bytes);
  const {metresPerUnit} = await exporting(app);
  checkJoints(loaded, await app.page.evaluate(() => marrow.rig()), metresPerUnit);
  assert.deepEqual(loaded.gltf.animations.map((clip) => clip.name), [pose]);
  const {vertices, triangles} = await posed(app);
  assert.deepEqual(indices(loaded).flat(), triangles);
  const rest = loaded.meshes[0].geometry.attributes.position;
  const moved = vertices.filter((v, i) => apart(v, [rest.getX(i), rest.getY(i), rest.getZ(i)]
      .map((x) => x / metresPerUnit)) > 10).length;
  assert.ok(moved > vertices.length / 20, `${moved} of ${vertices.length} vertices are moved`);
  const worst = worstVertex(loaded, pose, {vertices, groups: indices(loaded)}, metresPerUnit);
  assert.ok(worst < 1e-4, `a vertex is off by ${worst} of the size`);
  console.log(`        ${took_s} s to the file; a posed vertex is off by ${worst.toExponential(1)}`);
});

test('every format is a file of its kind, of the pose that is chosen', plain, async (app) => {
  await openPosing(app, 'dog');
  await pull(app, 'Front leg.R.6', [60, -40]);
  const there = (await posed(app)).vertices;
  await app.press('pose', 'export');
  const files = {};
  for (const format of ['glb', 'gltf', 'obj', 'stl', 'ply']) {
    await app.press('export', format);
    assert.equal((await exporting(app)).format, format);
    const {name, bytes} = await save(app);
    assert.match(name, new RegExp(`^[^.]+\\.${format}$`));
    assert.ok(bytes.length > 20_000, `${name}: ${bytes.length} bytes`);
    files[format] = bytes;
    await app.screenshot(format);
  }
  await validate('glb', files.glb);
  await validate('gltf', files.gltf);
  assert.equal(files.glb.toString('latin1', 0, 4), 'glTF');
  assert.equal(JSON.parse(files.gltf.toString()).asset.version, '2.0');
  assert.equal(files.stl.length, 84 + 50 * files.stl.readUInt32LE(80));
  assert.match(files.ply.toString('latin1', 0, 200), /^ply\nformat binary_little_endian 1\.0\n/);

  const lines = files.obj.toString().split('\n');
  const vertices = lines.filter((line) => line.startsWith('v '))
      .map((line) => line.split(' ').slice(1).map(Number));
  assert.equal(vertices.length, there.length);
  assert.ok(vertices.every((v, i) => apart(v, there[i]) < 0.02), 'the pose as it is seen');
  await app.press('export', 'obj');
  await app.press('export', 'rest');
  const rest = (await save(app)).bytes.toString();
  assert.notEqual(rest.slice(0, 5000), files.obj.toString().slice(0, 5000));
});

test('the size, the parts and the weights are as chosen', plain, async (app) => {
  await openPosing(app, 'dog');
  await app.key('p');
  await openSheet(app);
  await app.screenshot('sheet');
  const plainly = await load((await save(app)).bytes);
  assert.ok(Math.abs(heightOf(plainly) - 1) < 0.02, `${heightOf(plainly)} m`);
  assert.equal(plainly.meshes[0].isSkinnedMesh, true);
  await app.press('export', 'large');
  await app.press('export', 'parts');
  await app.press('export', 'weights');
  await app.screenshot('sheet-changed');
  const {bytes} = await save(app);
  await validate('parts', bytes);
  const {meshes, ...loaded} = await load(bytes);
  assert.ok(Math.abs(heightOf(loaded) - 2) < 0.04, `${heightOf(loaded)} m`);
  const {parts} = await app.page.evaluate(() => marrow.document());
  assert.equal(meshes.length, parts.length + parts.filter(({mirror}) => mirror).length);
  assert.ok(meshes.every((mesh) => !mesh.isSkinnedMesh));
});

test('an empty drawing is told so, and offers no button', plain, async (app) => {
  await openSheet(app);
  assert.equal((await exporting(app)).nothing, true);
  assert.ok(await has(app, 'export', 'close'));
  assert.ok(!await has(app, 'export', 'save'));
  await app.screenshot('empty');
  await app.press('export', 'close');
  assert.ok(!await has(app, 'export', 'close'));
});

const sample = async (name) =>
    JSON.parse(await readFile(join(root, 'public/samples', `${name}.json`), 'utf8'));
const show = (app, document) => app.page.evaluate((json) => marrow.load(json), document);
const meshesOf = ({parts}) => parts.length + parts.filter(({mirror}) => mirror).length;

test('a file waits for the figure, and neither takes the place of the other', plain, async (app) => {
  const dragon = await sample('dragon');
  await show(app, await sample('bear'));
  await app.frames(2);
  await openSheet(app);
  await ready(app);
  await app.settled();
  const {x, y} = await app.widget('export', 'save');
  const {bytes} = await app.downloaded(async () => {
    await show(app, dragon);
    await app.until(() => marrow.stats().posing.done >= 0);
    await app.page.mouse.click(x, y);
    await app.screenshot('waiting');
  });
  await validate('dragon', bytes);
  assert.equal((await load(bytes)).meshes.length, meshesOf(dragon), 'the newest drawing');
  assert.ok((await posing(app)).ready);
  assert.equal((await posing(app)).made, 2, 'each figure was made once');

  // What changes meanwhile changes nothing of the file, and the figure of that is made after it.
  const late = await app.downloaded(async () => {
    await app.press('export', 'parts');
    const now = await app.widget('export', 'save');
    await app.page.mouse.click(now.x, now.y);
    await app.frames(3);
    await show(app, await sample('bear'));
  });
  await validate('dragon', late.bytes);
  assert.equal((await load(late.bytes)).meshes.length, meshesOf(dragon));
  await ready(app);
});

test('a file that is given up is not made, and all goes on', {init: () => {
  delete window.showSaveFilePicker;
  // Work that takes as long as the test wants.
  window.held_ms = 0;
  window.Worker = class extends window.Worker {
    postMessage(data) {
      setTimeout(() => super.postMessage(data), data.request ? window.held_ms : 0);
    }
  };
}}, async (app) => {
  const hold = (ms) => app.page.evaluate((time) => { window.held_ms = time; }, ms);
  await show(app, await sample('dragon'));
  await app.frames(2);
  await openSheet(app);
  await ready(app);
  await app.settled();
  let downloads = 0;
  app.page.on('download', () => ++downloads);
  await hold(600_000);
  const {x, y, width} = await app.widget('export', 'save');
  await app.page.mouse.dblclick(x + width / 2 - 20, y);  // where the way out appears
  await app.settled();
  assert.ok(await has(app, 'export', 'cancel'));
  await app.screenshot('making');
  await later(app);
  await app.press('export', 'cancel');
  await app.until(() => !marrow.stats().export.waiting && !marrow.stats().export.working);
  assert.equal((await exporting(app)).failure, '');
  assert.equal((await app.stats()).message, 'No file was made.');
  await app.page.mouse.click(x + width / 2 - 20, y);  // once more, by mistake
  await app.settled();
  assert.ok(await has(app, 'export', 'save'));
  await later(app);

  // The figure of a drawing that changed while a file was made is made once that is given up.
  await app.press('export', 'save');
  await show(app, await sample('bear'));
  await hold(0);
  await later(app);
  await app.press('export', 'cancel');
  await ready(app);
  await app.settled();
  assert.equal(downloads, 0);
  await validate('bear', (await save(app)).bytes);
});

test('where the browser can, the user says where the file goes', {init: () => {
  // A browser's own dialogs cannot be pressed by a test: these answer at once.
  window.written = {};
  window.showSaveFilePicker = async ({suggestedName, types}) => {
    window.asked = {suggestedName, types};
    if (window.refuse) throw new DOMException('', window.refuse);
    return {name: suggestedName, createWritable: async () => ({
      write: async (bytes) => { window.written[suggestedName] = bytes.length; },
      close: async () => {},
    })};
  };
}}, async (app) => {
  const refuse = (why) => app.page.evaluate((name) => { window.refuse = name; }, why);
  await openPosing(app, 'fish');
  await app.press('pose', 'export');
  await app.press('export', 'save');
  await app.until(() => Object.keys(window.written).length === 1);
  const [[name, size]] = await app.page.evaluate(() => Object.entries(window.written));
  assert.match(name, /\.glb$/);
  assert.ok(size > 20_000);
  await app.until((file) => marrow.stats().message === `Saved ${file}.`, name);

  // Too long after the press for a dialog: it is downloaded.
  await refuse('SecurityError');
  const {bytes} = await save(app);
  assert.equal(bytes.length, size);

  // Thought better of it.
  await refuse('AbortError');
  let downloads = 0;
  app.page.on('download', () => ++downloads);
  const {frames} = await app.stats();
  await app.page.evaluate(() => { window.asked = null; });
  await later(app);
  await app.press('export', 'save');
  await app.until(() => window.asked);
  await app.settled();
  assert.equal(downloads, 0);
  assert.ok((await app.stats()).frames > frames);
});

test('the sheet shows the body that will be saved; soft seams are undone', plain, async (app) => {
  await openPosing(app, 'dog');
  await app.key('p');
  await openSheet(app);
  const before = await posed(app);
  const slider = await app.widget('export', 'blend');
  await app.drag([slider.x - slider.width / 2 + 10, slider.y], [slider.x + slider.width / 4, slider.y], {
    before: () => app.until(() => marrow.posed() !== null),
  });
  const {blend} = await app.page.evaluate(() => marrow.document());
  assert.ok(blend > 5, `${blend}`);
  await ready(app);
  const soft = await posed(app);
  assert.ok(soft.vertices.length !== before.vertices.length ||
            soft.vertices.some((v, i) => apart(v, before.vertices[i]) > 0.5));
  await app.screenshot('soft-seams');
  await app.key('Control+z');
  await ready(app);
  assert.deepEqual(await posed(app), before);
});

for (const [name, options] of [['phone', {width: 360, height: 740, touch: true, scale: 2}],
                               ['phone-across', {width: 740, height: 360, touch: true, scale: 2}],
                               ['laptop-2x', {width: 1280, height: 800, scale: 2}]]) {
  test(`the sheet fits: ${name}`, {...plain, ...options}, async (app) => {
    await openPosing(app, 'dog');
    await pull(app, 'Front leg.R.6', [20, -20]);
    await openSheet(app);
    await app.screenshot(`${name}-glb`);
    await app.press('export', 'stl');
    await app.screenshot(`${name}-stl`);
    const {bytes} = await save(app);
    assert.equal(bytes.length, 84 + 50 * bytes.readUInt32LE(80));
  });
}

test('a worker that breaks down says so, hangs nothing, and the next one does the work', sick,
     async (app) => {
       await openPosing(app, 'fish', {waits: false});
       await app.until(() => marrow.stats().posing.failure.includes('no memory left'));
       await app.screenshot('sick');
       await app.press('pose', 'export');
       await app.press('export', 'save');
       await app.until(() => marrow.stats().export.failure.includes('no memory left'));
       await app.screenshot('sick-file');
       await app.page.evaluate(() => heal());
       const {bytes} = await save(app);
       assert.equal(bytes.subarray(0, 4).toString(), 'glTF');
     });
