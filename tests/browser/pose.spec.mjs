// Poses, by hand: the character follows its joints, and what is done has names and can be undone.
import assert from 'node:assert/strict';
import {readFile} from 'node:fs/promises';
import {join} from 'node:path';

import {isBody, root, test} from './harness.mjs';
import {apart, glidden, joint, openPosing, poses, posing, pull, ready} from './posing.mjs';

test('a limb follows the joint that is pulled, the others stay, and undo brings it back',
     async (app) => {
  await openPosing(app, 'dog');
  const paw = 'Front leg.L.6', other = 'Hind leg.L.5';  // those in front
  const before = {paw: await joint(app, paw), other: await joint(app, other)};
  const [x, y] = [before.paw.pixel[0] + 90, before.paw.pixel[1] - 60];
  const skinThere = async () =>
      (await app.pixels()).find(isBody, [x - 12, y - 12, x + 12, y + 12]).count;
  assert.equal(await skinThere(), 0, 'nothing is there yet');
  let seen;
  await pull(app, paw, [90, -60], {
    async before() {
      await app.frames(2);
      seen = await skinThere();
    },
  });
  assert.ok(seen > 50, 'the skin is there while the button is down');
  const after = await joint(app, paw);
  assert.ok(apart(after.pixel, [x, y]) < 2);
  assert.ok(apart((await joint(app, other)).position, before.other.position) < 1e-9);
  assert.equal((await posing(app)).pose, 'Pose 1');
  assert.equal((await poses(app)).length, 1);
  await app.screenshot('pulled');

  await app.key('Control+z');
  await glidden(app);
  assert.ok(apart((await joint(app, paw)).position, before.paw.position) < 1e-9);
  assert.equal((await poses(app)).length, 0);
  await app.key('Control+y');
  await glidden(app);
  assert.ok(apart((await joint(app, paw)).position, after.position) < 1e-9);
  await app.key('p');
  assert.equal((await app.stats()).tool, 'draw');
  assert.equal((await poses(app)).length, 1, 'a pose is kept in the drawing');
});

test('a limb is pulled by its skin too, and beside the character the view turns', async (app) => {
  await openPosing(app, 'dog');
  const [ax, ay] = (await joint(app, 'Hind leg.L.4')).pixel, [bx, by] = (await joint(app, 'Hind leg.L.5')).pixel;
  const grip = [ax * 0.2 + bx * 0.8 + 6, ay * 0.2 + by * 0.8];
  await app.drag(grip, [grip[0] - 60, grip[1] - 20]);
  assert.equal((await poses(app)).length, 1);
  const {yaw} = (await app.stats()).camera;
  await app.drag([300, 700], [420, 690]);
  assert.ok(Math.abs((await app.stats()).camera.yaw - yaw) > 0.1);
  assert.equal((await poses(app)).length, 1);
});

test('what is pinned stays, and what hangs behind it follows', async (app) => {
  await openPosing(app, 'dog');
  const pinned = await joint(app, 'Tail.2');
  await app.click(...pinned.pixel);
  assert.equal((await posing(app)).joint, pinned.id);
  await app.key('n');
  assert.deepEqual((await posing(app)).pins, [pinned.id]);
  const body = await joint(app, 'Body.3');
  await pull(app, 'Tail.8', [40, 60]);
  assert.ok(apart((await joint(app, 'Tail.2')).position, pinned.position) < 1e-6);
  assert.ok(apart((await joint(app, 'Body.3')).position, body.position) < 1e-9);
  await app.screenshot('pinned');
  await app.click(...(await joint(app, 'Tail.2')).pixel);
  await app.press('pose', 'pin');
  assert.deepEqual((await posing(app)).pins, []);
});

test('R turns the chosen bone by a number, T makes drags turn, G moves the whole character',
     async (app) => {
  await openPosing(app, 'dog');
  const hip = await joint(app, 'Front leg.L.5'), paw = await joint(app, 'Front leg.L.6');
  const length = apart(hip.position, paw.position);
  await app.click(...paw.pixel);
  await app.key('r');
  for (const key of '90') await app.key(key);
  await app.key('Enter');
  const turned = await joint(app, 'Front leg.L.6');
  const cosine = [0, 1, 2].reduce((sum, k) => sum + (paw.position[k] - hip.position[k]) *
      (turned.position[k] - hip.position[k]), 0) / length ** 2;
  // About the line of sight: what lies along it stays.
  assert.ok(Math.abs(cosine) < 0.2, `${cosine}`);
  assert.ok(Math.abs(apart(hip.position, turned.position) - length) < 1e-6 * length);

  await app.key('t');
  const [x, y] = turned.pixel;
  await app.drag([x, y], [x - 30, y + 50]);
  assert.ok(apart((await joint(app, 'Front leg.L.5')).position, hip.position) < 1e-6);
  await app.key('t');

  const root = (await posing(app)).joints[0], tail = await joint(app, 'Tail.8');
  await app.click(...root.pixel);
  await app.key('g');
  await app.key('x');
  for (const key of '50') await app.key(key);
  await app.key('Enter');
  const moved = await joint(app, 'Tail.8');
  assert.ok(Math.abs(moved.position[0] - tail.position[0] - 50) < 1e-6);
  assert.equal((await poses(app)).length, 1);
});

test('poses have names, are mirrored, mixed and put back', async (app) => {
  await openPosing(app, 'dog');
  await pull(app, 'Front leg.L.6', [60, -40]);
  const right = await joint(app, 'Front leg.L.6');
  await app.press('pose', 'name');
  await app.page.keyboard.press('Control+a');
  await app.page.keyboard.type('Give paw');
  await app.key('Enter');
  assert.deepEqual((await poses(app)).map(({name}) => name), ['Give paw']);
  assert.equal((await posing(app)).pose, 'Give paw');

  await app.press('pose', 'mirror');
  await glidden(app);
  const left = await joint(app, 'Front leg.R.6');
  assert.ok(Math.abs(left.position[0] - right.position[0]) < 1e-6, 'the other paw');
  assert.ok(Math.abs(left.position[2] + right.position[2]) < 1e-6);

  await app.press('pose', 'new');
  await app.press('pose', 'resetAll');
  await glidden(app);
  const rest = await joint(app, 'Front leg.R.6');
  const slider = await app.widget('pose', 'mix');
  // With "Give paw", behind the rest among the others.
  await app.press('pose', 'other');
  await app.drag([slider.x - slider.width / 2 + 8, slider.y], [slider.x, slider.y]);
  const between = await joint(app, 'Front leg.R.6');
  const way = apart(rest.position, left.position);
  assert.ok(apart(rest.position, between.position) > 0.2 * way, 'half way');
  assert.ok(apart(left.position, between.position) > 0.2 * way);
  await app.screenshot('mixed');
  await app.press('pose', 'keepMix');
  await glidden(app);
  assert.equal((await poses(app)).length, 3);
  assert.ok(apart((await joint(app, 'Front leg.R.6')).position, between.position) < 1e-6);

  await app.press('pose', 'rest');
  await glidden(app);
  assert.equal((await posing(app)).pose, null);
  assert.ok(apart((await joint(app, 'Front leg.R.6')).position, rest.position) < 1e-6);
  for (let i = 0; i < 3; ++i) await app.press('pose', 'delete');
  assert.equal((await poses(app)).length, 0);
  await app.key('Control+z');
  assert.equal((await poses(app)).length, 1);
});

test('a mix outlives a press, and ends when a pose is chosen or a joint is pulled', async (app) => {
  await openPosing(app, 'dog');
  const rest = await joint(app, 'Front leg.L.6');
  await pull(app, 'Front leg.L.6', [60, -40]);
  const posed = await joint(app, 'Front leg.L.6');
  const mixHalf = async () => {
    const slider = await app.widget('pose', 'mix');
    const left = slider.x - slider.width / 2 + 8;
    await app.drag([left, slider.y], [slider.x, slider.y]);
  };
  await mixHalf();
  const mixed = await joint(app, 'Front leg.L.6');
  assert.ok(apart(mixed.position, posed.position) > 5 && apart(mixed.position, rest.position) > 5);
  const still = async () => {
    await glidden(app);
    assert.ok(apart((await joint(app, 'Front leg.L.6')).position, mixed.position) < 1e-9);
    assert.equal((await posing(app)).pose, 'Pose 1');
  };
  await app.click(...(await joint(app, 'Tail.8')).pixel);
  await still();
  const [x, y] = (await joint(app, 'Tail.8')).pixel;
  await app.page.mouse.move(x, y);
  await app.page.mouse.down();
  await app.page.mouse.move(x + 30, y + 40, {steps: 4});
  await app.frames(3);
  assert.equal((await posing(app)).pose, null, 'what is pulled becomes a pose of its own');
  await app.key('Escape');
  await app.page.mouse.up();
  await still();
  assert.equal((await poses(app)).length, 1);

  await app.press('pose', 'rest');
  await glidden(app);
  assert.ok(apart((await joint(app, 'Front leg.L.6')).position, rest.position) < 1e-9);
});

test('a pose that is renamed stays chosen when that is undone and done again', async (app) => {
  await openPosing(app, 'dog');
  await pull(app, 'Front leg.L.6', [60, -40]);
  const posed = await joint(app, 'Front leg.L.6');
  await app.press('pose', 'name');
  await app.page.keyboard.press('Control+a');
  await app.page.keyboard.type('Give paw');
  await app.key('Enter');
  for (const [key, name] of [['Control+z', 'Pose 1'], ['Control+y', 'Give paw']]) {
    await app.key(key);
    await glidden(app);
    assert.equal((await posing(app)).pose, name);
    assert.ok(apart((await joint(app, 'Front leg.L.6')).position, posed.position) < 1e-9);
  }
});

test('a bone is put back alone, and the whole stays where it is', async (app) => {
  await openPosing(app, 'dog');
  const root = (await posing(app)).joints[0];
  await pull(app, root.name, [30, -20]);
  await pull(app, 'Front leg.L.6', [60, -40]);
  const moved = await joint(app, root.name);
  assert.ok(apart(moved.position, root.position) > 10);
  const paw = await joint(app, 'Front leg.L.6');
  await app.press('pose', 'resetBone');
  await glidden(app);
  assert.ok(apart((await joint(app, 'Front leg.L.6')).position, paw.position) > 5);
  assert.ok(apart((await joint(app, root.name)).position, moved.position) < 1e-9);
});

test('the model moves beside the panel, and back', async (app) => {
  await openPosing(app, 'fish');
  await app.key('p');
  await app.settled();
  const {camera} = await app.stats();
  const right = async () => Math.max(...(await posing(app)).joints.map(({pixel}) => pixel[0]));
  await app.key('p');
  await app.settled();
  const panel = (await app.stats()).widgets.find((one) => one.panel === 'pose' && one.id === 'new');
  assert.ok(await right() < panel.x, `${await right()}`);
  await app.screenshot('beside');
  await app.key('p');
  await app.settled();
  assert.deepEqual((await app.stats()).camera, camera);
});

test('a pose keeps what still applies when the skeleton is refined', async (app) => {
  await openPosing(app, 'dog');
  await pull(app, 'Front leg.L.6', [60, -40]);
  const [pose] = await poses(app);
  const before = (await posing(app)).joints.length;
  await app.page.evaluate(() => marrow.load({...marrow.document(), refine: {simplify: 60}}));
  await app.frames(2);
  await ready(app);
  const now = await posing(app);
  assert.ok(now.joints.length < before);
  assert.deepEqual((await poses(app))[0].joints, pose.joints);
  const bent = Object.keys(pose.joints).filter((id) => now.joints.some((one) => one.id === id));
  assert.ok(bent.length > 0);
  await app.screenshot('refined');
});

test('the skin is fitted again by itself, and the newest drawing wins', async (app) => {
  const text = async (name) => readFile(join(root, 'public/samples', `${name}.json`), 'utf8');
  await app.key('p');
  assert.equal((await app.stats()).tool, 'draw', 'there is nothing to pose yet');
  await app.page.evaluate((json) => marrow.load(json), await text('dragon'));
  await app.frames(2);
  await app.page.keyboard.press('p');
  await app.until(() => marrow.stats().posing.made === 1);
  await app.page.evaluate((json) => marrow.load(json), await text('bear'));
  await app.until(() => marrow.stats().posing.ready);
  const {joints, made, figure} = await posing(app);
  const rig = await app.page.evaluate(() => marrow.rig());
  assert.deepEqual(joints.map(({id}) => id), rig.joints.map(({id}) => id));
  assert.equal(made, 2);
  assert.ok(!figure.guessed && figure.triangles > 1000);
});

test('a new drawing is drawn on at once, and knows no pose of the one before', async (app) => {
  await openPosing(app, 'dog');
  await pull(app, 'Front leg.L.6', [40, -30]);
  await app.key('n');
  assert.equal((await posing(app)).pins.length, 1);
  await app.press('toolbar', 'new');
  const {tool, posing: now} = await app.stats();
  assert.equal(tool, 'draw');
  assert.deepEqual([now.pose, now.joint, now.pins], [null, '', []]);
  await app.key('Control+z');
  await app.key('p');
  assert.equal((await app.stats()).tool, 'pose');
  assert.equal((await poses(app)).length, 1);
});

test('the weights are shown, of all bones or of the chosen one', async (app) => {
  await openPosing(app, 'dog');
  const [x, y] = (await joint(app, 'Front leg.L.6')).pixel;
  const at = async () => (await app.pixels()).at(x + 12, y);
  const plain = await at();
  await app.key('w');
  const all = await at();
  assert.notDeepEqual(all, plain);
  await app.screenshot('weights-all');
  await app.key('w');
  await app.click(x, y);
  const hot = await at();
  await app.screenshot('weights-one');
  assert.ok(hot[0] > 180 && hot[2] < hot[0], `${hot}: light where the bone holds`);
  const [bx, by] = (await joint(app, 'Tail.8')).pixel;
  const cold = (await app.pixels()).at(bx, by + 9);
  assert.ok(cold[0] < 120, `${cold}: dark where it does not`);
  await app.key('w');
  assert.deepEqual(await at(), plain);
});

test('a brush gives a bone more of the skin, is undone, and its paint can be cleared', async (app) => {
  await openPosing(app, 'dog');
  await app.click(...(await joint(app, 'Tail.8')).pixel);
  await app.key('w');
  await app.key('w');
  const [x, y] = (await joint(app, 'Tail.4')).pixel;
  const at = async () => (await app.pixels()).at(x + 7, y);
  const cold = await at();
  await app.press('pose', 'add');
  const strokes = () => app.page.evaluate(() => (marrow.document().weightStrokes ?? []).length);
  await app.drag([x - 5, y - 5], [x + 8, y + 8], {
    async before() { await app.until(() => marrow.stats().posing.made > 1); },
  });
  assert.equal(await strokes(), 1);
  assert.equal((await poses(app)).length, 0, 'the brush pulls nothing');
  await ready(app);
  await app.settled();
  const hot = await at();
  assert.ok(hot[0] > cold[0] + 60, `${cold} became ${hot}`);
  await app.screenshot('brushed');
  await app.key('Control+z');
  await ready(app);
  await app.settled();
  assert.deepEqual(await at(), cold);
  await app.key('Control+y');
  await app.press('pose', 'clearPaint');
  assert.equal(await strokes(), 0);
  await ready(app);
  await app.settled();
  assert.deepEqual(await at(), cold);
  // Without a chosen bone only smoothing has something to do.
  await app.key('Escape');
  assert.equal((await posing(app)).joint, '');
  await app.drag([x - 5, y - 5], [x + 8, y + 8]);
  assert.equal(await strokes(), 0);
  assert.match((await app.stats()).message, /Click the joint/);
  await app.press('pose', 'smooth');
  await app.drag([x - 5, y - 5], [x + 8, y + 8]);
  assert.equal(await strokes(), 1);
  await app.press('pose', 'clearAll');
  assert.equal(await strokes(), 0);
  await app.press('pose', 'back');
  assert.ok((await app.stats()).widgets.some(({panel, id}) => panel === 'pose' && id === 'new'));
});

test('fingers pose as well: one pulls, beside the character one turns the view, two pinch',
     {width: 800, height: 600, touch: true}, async (app) => {
  await openPosing(app, 'dog');
  const way = ([x, y], [dx, dy]) => Array.from({length: 12}, (_, i) => [x + dx * i / 11, y + dy * i / 11]);
  const {pixel} = await joint(app, 'Front leg.L.6');
  await app.touch([way(pixel, [30, -30])]);
  assert.equal((await poses(app)).length, 1);
  const before = (await app.stats()).camera;
  await app.touch([way([200, 500], [90, 0])]);
  assert.ok(Math.abs((await app.stats()).camera.yaw - before.yaw) > 0.1);
  await app.touch([way([300, 500], [-80, 0]), way([360, 500], [80, 0])]);
  assert.ok((await app.stats()).camera.zoom > before.zoom * 1.2);
  assert.equal((await poses(app)).length, 1);
});
