// The thresholds: four sliders, three scopes.
import assert from 'node:assert/strict';

import {dense, test} from './harness.mjs';

const snake = dense([[250, 600], [370, 540], [510, 590], [650, 540], [810, 600], [820, 640],
                     [650, 600], [510, 640], [370, 600], [260, 640], [250, 600]], 6);
const star = dense([[500, 150], [540, 270], [660, 240], [580, 330], [680, 420], [550, 400],
                    [500, 510], [450, 400], [320, 420], [420, 330], [340, 240], [460, 270],
                    [500, 150]], 6);
const tall = {height: 1080};  // the whole panel is seen
const refinement = (app) => app.page.evaluate(() => {
  const {refine, parts} = marrow.document();
  return {model: refine ?? {}, parts: parts.map((part) => part.refine ?? {})};
});
const joints = (app) => app.page.evaluate(() => marrow.rig().joints.length);

async function drawn(app) {
  await app.draw(star);
  await app.draw(snake);
  assert.equal((await app.parts()).length, 2);
}

/// Pulls a slider from where it stands by default to a share of its length.
async function pull(app, panel, id, share) {
  const {x, y, width} = await app.widget(panel, id);
  await app.drag([x, y], [x - width / 2 + width * share, y]);
}

test('each slider changes its own threshold, and a reset restores every joint', async (app) => {
  await drawn(app);
  await app.key('Escape');
  await app.press('switches', 'skeleton');
  await app.screenshot('model');
  const text = await app.document();
  for (const id of ['simplify', 'merge', 'prune', 'collapse']) {
    const before = await joints(app);
    await pull(app, 'refine', id, 0.05);
    const {model} = await refinement(app);
    assert.deepEqual(Object.keys(model), [id]);
    assert.ok(model[id] > 20, `${id} ${model[id]}`);
    assert.ok(await joints(app) <= before, `${id}: fewer joints`);
    await app.press('refine', 'reset');
    assert.equal(await app.document(), text);
    assert.equal(await joints(app), before);
  }
  await pull(app, 'refine', 'simplify', 1);
  assert.equal((await refinement(app)).model.simplify, 0, 'the finest');
  await app.key('Control+z');
  assert.equal(await app.document(), text);
});

test('a narrower scope wins, and says so', tall, async (app) => {
  await drawn(app);
  await app.press('part', 'skeleton');
  await app.screenshot('part');
  const standard = await joints(app);
  await pull(app, 'part', 'simplify', 0.9);
  const {parts, model} = await refinement(app);
  assert.ok(parts[1].simplify < 3 && parts[0].simplify === undefined);
  assert.deepEqual(model, {});
  const fine = await joints(app);
  assert.ok(fine > standard, `${fine} > ${standard}`);

  await app.press('part', 'scopeModel');
  await pull(app, 'part', 'simplify', 0.1);
  assert.ok((await refinement(app)).model.simplify > 20);
  await app.screenshot('model-and-part');
  await app.press('part', 'resetWithin');
  assert.deepEqual(await refinement(app), {model: {}, parts: [{}, {}]});
  assert.equal(await joints(app), standard);
});

test('a branch has a detail of its own', tall, async (app) => {
  await drawn(app);
  await app.click(150, 150);
  const bone = await app.page.evaluate(() => {
    const {joints, bones} = marrow.rig();
    const {target, zoom} = marrow.stats().camera;
    const {width, height} = marrow.stats().canvas;
    const at = (id) => joints.find((joint) => joint.id === id).position;
    const own = bones.map(([a, b]) => [at(a), at(b)])
        .sort((p, q) => p[0][1] + p[1][1] - q[0][1] - q[1][1])[0];
    const middle = [0, 1].map((k) => (own[0][k] + own[1][k]) / 2);
    return [width / 2 + (middle[0] - target[0]) * zoom, height / 2 - (middle[1] - target[1]) * zoom];
  });
  await app.click(...bone);
  assert.notEqual((await app.stats()).branch, '');
  await app.press('part', 'skeleton');
  await app.press('part', 'scopeBranch');
  await app.screenshot('branch');
  const before = await joints(app);
  await pull(app, 'part', 'simplify', 1);
  const branches = await app.page.evaluate(() => marrow.document().parts.map(
      (part) => Object.keys(part.refine?.branches ?? {}).length));
  assert.deepEqual(branches, [0, 1]);
  assert.ok(await joints(app) > before);
  await app.press('part', 'scopePart');
  await app.screenshot('part-with-branch');
  await app.press('part', 'resetWithin');
  assert.equal(await joints(app), before);
});
