// Several parts, their settings, undo and redo: by the controls a user has.
import assert from 'node:assert/strict';

import {circle, closed, dense, isBody, test} from './harness.mjs';

const ring = (x, y, radius) => dense(closed(circle(x, y, radius)), 10);
const snake = dense([[300, 600], [420, 560], [560, 600], [700, 560], [860, 610], [870, 640],
                     [700, 600], [560, 640], [420, 600], [310, 640], [300, 600]], 6);
const settings = (app, index) => app.page.evaluate((i) => {
  const {thickness, color, refine, name} = marrow.document().parts[i];
  return {thickness, color, refine, name};
}, index);

/// Does something, undoes it by one way and redoes it by another; all texts must be the same again.
async function undoable(app, act, way = 0) {
  const before = await app.document();
  await act();
  const after = await app.document();
  assert.notEqual(after, before);
  const undo = [() => app.key('Control+z'), () => app.press('toolbar', 'undo'),
                () => app.page.evaluate(() => marrow.undo())];
  const redo = [() => app.key('Control+Shift+z'), () => app.press('toolbar', 'redo'),
                () => app.page.evaluate(() => marrow.redo()), () => app.key('Control+y')];
  await undo[way % undo.length]();
  assert.equal(await app.document(), before, 'undone');
  await redo[way % redo.length]();
  assert.equal(await app.document(), after, 'redone');
}

test('parts are kept, selected by a click, changed, deleted, and all of it is undone', async (app) => {
  await undoable(app, () => app.draw(ring(420, 300, 110)), 0);
  await undoable(app, () => app.draw(ring(720, 300, 90)), 1);
  await undoable(app, () => app.draw(snake), 2);
  assert.equal((await app.parts()).length, 3);
  assert.equal((await app.stats()).selected, 'part-3', 'the new one is selected');
  const document = await app.page.evaluate(() => marrow.document());
  assert.equal(new Set(document.parts.map((part) => part.color)).size, 3, 'colours differ');
  await app.screenshot('three-parts');

  await app.click(420, 250);
  assert.equal((await app.stats()).selected, 'part-1');
  await app.click(600, 480);
  assert.equal((await app.stats()).selected, null, 'a click beside the parts');
  await app.click(720, 250);
  assert.equal((await app.stats()).selected, 'part-2');

  // Thickness: while the hand is on the slider the part swells and the document waits.
  await app.key('3');
  const thickness = await app.widget('part', 'thickness');
  const width = async () => {
    const {positions} = await app.page.evaluate(() => {
      const {positions} = marrow.mesh(1);
      return {positions: Array.from(positions)};
    });
    return Math.max(...positions.filter((_, i) => i % 3 === 2));
  };
  const [thin, still] = [await width(), await app.document()];
  await undoable(app, () => app.drag([thickness.x, thickness.y],
                                     [thickness.x + thickness.width / 4, thickness.y], {
    async before() {
      await app.until((w) => Math.max(...marrow.mesh(1).positions.filter((_, i) => i % 3 === 2)) > w,
                      1.3 * thin);
      assert.equal(await app.document(), still, 'the document waits for the hand');
    },
  }), 1);
  const fat = await settings(app, 1);
  assert.ok(fat.thickness > 1.3, `thickness ${fat.thickness}`);
  assert.ok(Math.abs(await width() / thin - fat.thickness) < 1e-6);
  await app.key('1');

  // Bones: fewer, and more.
  await app.click(580, 610);
  assert.equal((await app.stats()).selected, 'part-3');
  const bones = () => app.page.evaluate(() =>
      marrow.rig().joints.filter(({part}) => part === 'part-3').length);
  await app.press('part', 'skeleton');
  const simplify = await app.widget('part', 'simplify');
  const standard = await bones();
  await undoable(app, () => app.drag([simplify.x, simplify.y], [simplify.x - 100, simplify.y]), 0);
  const few = await bones();
  assert.ok((await settings(app, 2)).refine.simplify > 10);
  await undoable(app, () => app.drag([simplify.x - 100, simplify.y], [simplify.x + 100, simplify.y]), 1);
  assert.ok(few < standard && standard < await bones(), `${few} < ${standard} < ${await bones()}`);

  // Colour.
  const old = (await settings(app, 2)).color;
  await undoable(app, () => app.press('part', 'color', 5), 3);
  assert.notEqual((await settings(app, 2)).color, old);

  // Deleted by key and by button, and everything back one step after the other.
  await undoable(app, () => app.key('x'), 0);
  assert.deepEqual((await app.parts()).map((part) => part.id), ['part-1', 'part-2']);
  await app.click(420, 250);
  await undoable(app, () => app.press('part', 'delete'), 1);
  await undoable(app, () => app.press('toolbar', 'new'), 2);
  const none = await app.document();
  let steps = 0;
  while (await app.page.evaluate(() => marrow.undo())) ++steps;
  assert.equal(steps, 10);
  await app.settled();
  assert.equal((await app.pixels()).find(isBody, [230, 70, 980, 250]).count, 0, 'nothing is left');
  while (await app.page.evaluate(() => marrow.redo())) --steps;
  assert.equal(steps, 0);
  assert.equal(await app.document(), none);
});

test('a part is renamed in its panel, and keys that are letters stay letters there', async (app) => {
  await app.draw(ring(500, 400, 120));
  const {x, y} = await app.widget('part', 'name');
  await undoable(app, async () => {
    await app.click(x, y);
    await app.key('Control+a');
    await app.page.keyboard.type('Xerxes 137');
    await app.settled();
    await app.key('Enter');
  }, 2);
  assert.equal((await settings(app, 0)).name, 'Xerxes 137');
  assert.equal((await app.stats()).camera.view, 'front');
  assert.equal((await app.parts()).length, 1);
});

test('a name that was typed is kept, however its field is left', async (app) => {
  await app.draw(ring(400, 300, 100));
  await app.draw(ring(700, 300, 100));
  const names = () => app.page.evaluate(() => marrow.document().parts.map(({name}) => name));
  const type = async (panel, text) => {
    const {x, y} = await app.widget(panel, 'name');
    await app.click(x, y);
    await app.page.keyboard.type(text);
    await app.frames(3);
  };
  await type('part', 'Nose');
  await app.click(600, 650);
  assert.deepEqual(await names(), ['Part 1', 'Nose'], 'a click beside the parts');
  await app.click(700, 300);
  await type('part', 'Ear');
  await app.press('toolbar', 'frame');
  assert.equal((await names())[1], 'Ear', 'another button');
  await type('part', 'Eye');
  await app.key('Escape');
  assert.equal((await names())[1], 'Ear', 'Escape gives it up');
  await type('part', 'Tail');
  await app.draw(ring(600, 650, 50));
  assert.equal((await names())[1], 'Tail', 'a stroke');
  assert.equal((await names()).length, 3);
  await app.key('v');
  assert.equal((await app.stats()).tool, 'select', 'letters are keys again');

  await app.key('Escape');
  await app.press('toolbar', 'file');
  await type('file', 'Snail');
  await app.press('file', 'close');
  assert.equal((await app.stats()).drawing.name, 'Snail');
  await app.press('toolbar', 'file');
  await type('file', 'Slug');
  await app.drag([560, 760], [700, 780]);
  assert.equal((await app.stats()).drawing.name, 'Slug', 'a hand on the canvas');
});

test('Escape lets go of the parts, then closes what stands open; letters are keys with Caps Lock',
     async (app) => {
  const open = async (panel) => (await app.stats()).widgets.some((one) => one.panel === panel);
  await app.draw(ring(400, 300, 100));
  await app.press('switches', 'parts');
  await app.press('switches', 'skeleton');
  await app.key('Escape');
  assert.deepEqual((await app.stats()).selection, []);
  assert.ok(await open('parts') && await open('refine'));
  await app.key('Escape');
  assert.ok(!await open('parts') && !await open('refine'));
  for (const [key, tool] of [['V', 'select'], ['L', 'line'], ['B', 'draw']]) {
    await app.key(key);
    assert.equal((await app.stats()).tool, tool);
  }
  const {symmetry} = await app.stats();
  await app.key('M');
  assert.equal((await app.stats()).symmetry, !symmetry);
});

test('a deleted part gives its name to nobody, and the API loads what it saved', async (app) => {
  await app.draw(ring(400, 300, 100));
  await app.draw(ring(700, 300, 100));
  await app.key('Delete');
  await app.draw(ring(700, 500, 100));
  assert.deepEqual((await app.parts()).map((part) => part.id), ['part-1', 'part-3']);

  const saved = await app.document();
  const meshes = () => app.page.evaluate(() => marrow.parts().map((_, i) =>
      Array.from(marrow.mesh(i).positions).join()).join());
  const shapes = await meshes();
  await app.page.evaluate((json) => marrow.load({format: 'marrow', version: 1, parts: []}), saved);
  assert.equal((await app.parts()).length, 0);
  await app.page.evaluate((json) => marrow.load(json), saved);
  assert.equal(await app.document(), saved);
  assert.equal(await meshes(), shapes);

  const load = (json) => app.page.evaluate(
      (text) => marrow.load(text).then(() => 'loaded', (error) => error.message), json);
  const broken = ['', 'hello', 'null', '[]', '{"format": "other"}', saved.slice(0, -5),
                  saved.replace('"version":1', '"version":99'),
                  saved.replace('"points":[[', '"points":[["x",'), saved.replace('[[', '[[1e999,')];
  for (const json of broken) {
    assert.match(await load(json), /^\S.{8,200}\.$/s, json.slice(0, 40));
    assert.equal(await app.document(), saved);
  }
  assert.equal(await meshes(), shapes);
});

test('a mesh is a closed surface in typed arrays', async (app) => {
  await app.draw(snake);
  const mesh = await app.page.evaluate(() => {
    const {positions, normals, triangles} = marrow.mesh(0);
    const kinds = [positions, normals, triangles].map((array) => array.constructor.name);
    return {kinds, positions: [...positions], normals: [...normals], triangles: [...triangles]};
  });
  assert.deepEqual(mesh.kinds, ['Float64Array', 'Float64Array', 'Uint32Array']);
  const [part] = await app.parts();
  assert.equal(mesh.positions.length, 3 * part.mesh.vertices);
  assert.equal(mesh.normals.length, mesh.positions.length);
  assert.equal(mesh.triangles.length, 3 * part.mesh.triangles);

  // Each edge belongs to two triangles, once in each direction.
  const edges = new Set();
  for (let i = 0; i < mesh.triangles.length; i += 3) {
    for (let k = 0; k < 3; ++k) {
      const edge = `${mesh.triangles[i + k]} ${mesh.triangles[i + (k + 1) % 3]}`;
      assert.ok(!edges.has(edge), 'an edge twice in the same direction');
      edges.add(edge);
    }
  }
  for (const edge of edges) assert.ok(edges.has(edge.split(' ').reverse().join(' ')), 'a hole');
  assert.equal(part.mesh.triangles, 2 * part.mesh.vertices - 4, 'a sphere');
  for (let i = 0; i < mesh.normals.length; i += 3) {
    assert.ok(Math.abs(Math.hypot(...mesh.normals.slice(i, i + 3)) - 1) < 1e-9);
  }
  assert.equal(await app.page.evaluate(() => marrow.mesh(1)), null);
  assert.equal(await app.page.evaluate(() => marrow.mesh(-1)), null);
});
