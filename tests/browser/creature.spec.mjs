// A creature of many parts, drawn by hand: placing, symmetry, connecting, moving.
import assert from 'node:assert/strict';

import {dog, drawDog, ellipse, limb, ring} from './dog.mjs';
import {dense, test} from './harness.mjs';

const rig = (app) => app.page.evaluate(() => marrow.rig());
const placed = (joints) => [...new Set(joints.map((joint) => joint.part))];

test('body, four legs with two strokes, head and tail are one skeleton, in under a minute',
     async (app) => {
  const start = Date.now();
  await app.draw(dog.body);
  let live;
  await app.draw(dog.frontLeg, {
    async before() {
      await app.until(() => marrow.stats().preview.connections === 2);
      live = await app.screenshot('leg-under-the-pen');
    },
  });
  assert.ok(live);
  await app.draw(dog.hindLeg);
  await app.draw(dog.head);
  await app.draw(dog.tail);
  const took_s = (Date.now() - start) / 1000;
  assert.ok(took_s < 60, `${took_s} s`);

  const {joints, bones, roots, connections} = await rig(app);
  assert.equal(roots.length, 1, 'one skeleton');
  assert.equal(bones.length, joints.length - 1);
  assert.deepEqual(placed(joints).sort(), ['part-1', 'part-2', 'part-2:twin', 'part-3',
                                           'part-3:twin', 'part-4', 'part-5']);
  assert.equal(connections.length, 6);
  assert.ok(connections.every(({parent}) => parent === 'part-1'), JSON.stringify(connections));
  // The twins stand on either side of the body, as far from it.
  const depth = (part) => joints.find((joint) => joint.part === part).position[2];
  assert.ok(depth('part-2') > 20, `${depth('part-2')}`);
  assert.ok(Math.abs(depth('part-2') + depth('part-2:twin')) < 1e-6);
  for (const middle of ['part-4', 'part-5']) assert.equal(depth(middle), 0, middle);
  assert.ok(joints.some(({name}) => /\.L\b/.test(name)) && joints.some(({name}) => /\.R\b/.test(name)));
  await app.key('Escape');
  await app.screenshot('dog-front');
  await app.key('3');
  await app.screenshot('dog-right');
  await app.drag([600, 700], [520, 690], {button: 'right'});
  await app.screenshot('dog-turned');
});

test('a leg that is moved off is on its own, and moved on again it hangs where it was',
     async (app) => {
  await drawDog(app);
  const whole = await app.document(), joined = await rig(app);
  await app.key('v');
  assert.equal((await app.stats()).tool, 'select');
  await app.drag([717, 540], [1000, 640]);
  assert.equal((await app.stats()).selected, 'part-3');
  const apart = await rig(app);
  assert.equal(apart.roots.length, 3, 'the leg and its twin begin trees of their own');
  assert.equal(apart.connections.length, 4);
  await app.screenshot('leg-off');
  await app.drag([1000, 640], [717, 540], {
    async before() {
      await app.until(() => marrow.rig().connections.length === 6);
      await app.screenshot('leg-coming-back');
    },
  });
  const again = await rig(app);
  assert.deepEqual(again.connections, joined.connections);
  assert.deepEqual(again.joints.map(({id}) => id), joined.joints.map(({id}) => id));
  await app.key('Control+z');
  await app.key('Control+z');
  assert.equal(await app.document(), whole);
});

test('everything is undone, and done again', async (app) => {
  const documents = [await app.document()];
  const keep = async () => documents.push(await app.document());
  for (const name of ['body', 'frontLeg', 'head']) {
    await app.draw(dog[name]);
    await keep();
  }
  await app.key('v');
  await app.drag([525, 540], [560, 560]);
  await keep();
  await app.key('r');
  await app.page.keyboard.type('30');
  await app.key('Enter');
  await keep();
  await app.key('s');
  await app.key('y');
  await app.page.keyboard.type('1.5');
  await app.key('Enter');
  await keep();
  await app.key('Shift+D');
  await keep();
  await app.key('h');
  await keep();
  await app.key('Shift+H');
  await keep();
  await app.key('x');
  await keep();
  assert.equal(new Set(documents).size, documents.length - 1, 'hidden and shown is the same');
  for (let i = documents.length - 2; i >= 0; --i) {
    await app.key('Control+z');
    assert.equal(await app.document(), documents[i], `step ${i}`);
  }
  for (let i = 1; i < documents.length; ++i) {
    await app.key('Control+Shift+z');
    assert.equal(await app.document(), documents[i], `step ${i}`);
  }
});

test('a part drawn from the side lies in a plane that faces the viewer there', async (app) => {
  await app.draw(ring(640, 400, 120));
  await app.key('3');
  await app.draw(dense([[640, 380], [800, 360], [820, 420], [640, 430], [640, 380]], 6));
  const {parts: [, arm]} = await app.page.evaluate(() => marrow.document());
  const {frame: {x, y}} = arm;
  for (const [i, value] of [0, 0, -1].entries()) assert.ok(Math.abs(x[i] - value) < 1e-9);
  for (const [i, value] of [0, 1, 0].entries()) assert.ok(Math.abs(y[i] - value) < 1e-9);
  assert.equal((await rig(app)).roots.length, 1);
  await app.screenshot('from-the-side');
});

test('Shift at the start of a stroke draws as deep as the selected part', async (app) => {
  await app.draw(dog.body);
  await app.draw(dog.frontLeg);
  const depth = () => app.page.evaluate(() => marrow.document().parts.map(({frame}) => frame.origin[2]));
  const [, leg] = await depth();
  assert.ok(leg > 20);
  await app.page.keyboard.down('Shift');
  const foot = ring(500, 570, 30);
  await app.mouse([{type: 'mouseMoved', x: foot[0][0], y: foot[0][1], button: 'none', modifiers: 8}]);
  await app.mouse([{type: 'mousePressed', x: foot[0][0], y: foot[0][1], button: 'left', buttons: 1,
                    clickCount: 1, modifiers: 8}]);
  await app.mouse(foot.map(([x, y]) => ({type: 'mouseMoved', x, y, button: 'left', buttons: 1, modifiers: 8})));
  await app.mouse([{type: 'mouseReleased', x: foot.at(-1)[0], y: foot.at(-1)[1], button: 'left',
                    buttons: 0, clickCount: 1, modifiers: 8}]);
  await app.page.keyboard.up('Shift');
  await app.settled();
  const [, , deep] = await depth();
  assert.ok(Math.abs(deep - leg) < 1e-9, `${deep} is not ${leg}`);
});

test('a box selects what it touches, Shift adds and takes away, Escape lets go', async (app) => {
  await app.draw(ring(400, 300, 60));
  await app.draw(ring(640, 300, 60));
  await app.draw(ring(880, 300, 60));
  await app.key('Escape');
  await app.key('v');
  await app.drag([300, 420], [700, 310]);
  assert.deepEqual((await app.stats()).selection, ['part-1', 'part-2']);
  await app.screenshot('box');
  await app.page.keyboard.down('Shift');
  await app.click(880, 270);
  await app.click(400, 270);
  await app.page.keyboard.up('Shift');
  assert.deepEqual((await app.stats()).selection, ['part-2', 'part-3']);
  await app.key('Control+a');
  assert.equal((await app.stats()).selection.length, 3);
  await app.key('Escape');
  assert.deepEqual((await app.stats()).selection, []);
});

test('handles move along an axis, turn and scale; Escape and the right button give up',
     async (app) => {
  await app.draw(ring(640, 400, 70));
  await app.key('v');
  const frame = () => app.page.evaluate(() => marrow.document().parts[0].frame);
  const still = await app.document();
  await app.drag([640 + 60, 400], [640 + 160, 440]);  // on the arrow of X
  let now = await frame();
  assert.ok(Math.abs(now.origin[0] - 100) < 2 && Math.abs(now.origin[1]) < 1e-9, JSON.stringify(now));
  await app.key('Control+z');
  // A quarter turn by the outer ring.
  const turn = Array.from({length: 24}, (_, i) => {
    const angle = -0.4 - Math.PI / 2 * i / 23;
    return [640 + 98 * Math.cos(angle), 400 + 98 * Math.sin(angle)];
  });
  await app.draw(turn);
  now = await frame();
  assert.ok(Math.abs(now.x[1] - 1) < 0.05 && Math.abs(now.x[0]) < 0.05, JSON.stringify(now));
  await app.key('Control+z');
  // The knob that scales: twice as far from the middle.
  await app.drag([640 + 69, 400 - 69], [640 + 138, 400 - 138]);
  now = await frame();
  assert.ok(Math.abs(now.x[0] - 2) < 0.06, JSON.stringify(now));
  await app.key('Control+z');
  assert.equal(await app.document(), still);

  for (const giveUp of [() => app.key('Escape'),
                        () => app.page.mouse.click(700, 500, {button: 'right'})]) {
    await app.key('g');
    await app.page.mouse.move(700, 500);
    await app.page.mouse.move(800, 500);
    await app.screenshot('moved-by-key');
    await giveUp();
    await app.settled();
    assert.equal(await app.document(), still);
  }
  await app.page.mouse.move(640, 400);
  await app.key('g');
  await app.key('x');
  await app.page.keyboard.type('-25.5');
  await app.page.mouse.click(640, 400);
  await app.settled();
  assert.deepEqual((await frame()).origin, [-25.5, 0, 0]);
});

test('an outline is dragged by a point and drawn over, and the skeleton follows', async (app) => {
  await app.draw(ellipse(640, 400, 160, 60));
  await app.key('c');
  const area = () => app.page.evaluate(() => {
    const {points} = marrow.document().parts[0].stroke;
    return Math.abs(points.reduce((sum, [x, y], i) => {
      const [a, b] = points[(i + 1) % points.length];
      return sum + (x * b - a * y) / 2;
    }, 0));
  });
  const before = await area(), text = await app.document();
  await app.screenshot('outline');
  // A horn on top, drawn over the upper side.
  await app.draw(dense([[600, 342], [630, 220], [690, 345]], 6), {
    before: () => app.screenshot('outline-drawn-over'),
  });
  const horned = await area();
  assert.ok(horned > before + 3000, `${before} → ${horned}`);
  assert.ok((await rig(app)).joints.some(({position: [, y]}) => y > 60), 'a bone goes up into it');
  await app.key('Control+z');
  assert.equal(await app.document(), text);
  await app.key('c');
  assert.equal((await app.stats()).tool, 'reshape');
  await app.screenshot('outline-handles');
  await app.drag([800, 400], [900, 400], {before: () => app.screenshot('outline-dragged')});
  assert.ok(await area() > before + 1500, `${before} → ${await area()}`);
});

test('a half outline along a sketched line of symmetry becomes a whole one, what is off it gets a twin',
     async (app) => {
  await app.key('l');
  await app.drag([640, 150], [642, 650]);
  const {symmetry} = await app.page.evaluate(() => marrow.document());
  assert.ok(Math.abs(Math.abs(symmetry.plane[0]) - 1) < 1e-9, JSON.stringify(symmetry));
  assert.equal((await app.stats()).tool, 'draw');
  // The right half of a vase.
  await app.draw(dense([[640, 260], [720, 280], [690, 400], [760, 520], [640, 560]], 6), {
    before: () => app.screenshot('half-outline'),
  });
  const {parts: [vase]} = await app.page.evaluate(() => marrow.document());
  const xs = vase.stroke.points.map(([x]) => x);
  assert.ok(Math.abs(Math.min(...xs) + Math.max(...xs) - 2) < 2, 'as far to the left as to the right');
  assert.ok(Math.max(...xs) > 110 && !vase.mirror);
  // A handle of the vase.
  await app.draw(limb([[715, 480], [800, 440], [850, 380]], 14));
  const {parts: [, handle]} = await app.page.evaluate(() => marrow.document());
  assert.ok(handle.mirror);
  assert.equal((await rig(app)).connections.length, 2);
  await app.screenshot('vase');
});

test('fingers draw a creature on a phone', {width: 390, height: 760, touch: true, scale: 2},
     async (app) => {
  const small = (points) => points.map(([x, y]) => [(x - 620) * 0.55 + 200, (y - 400) * 0.55 + 400]);
  for (const name of ['body', 'frontLeg', 'hindLeg', 'head', 'tail']) {
    await app.touch([small(dog[name])]);
  }
  const {roots, connections} = await rig(app);
  assert.equal(roots.length, 1);
  assert.equal(connections.length, 6);
  await app.screenshot('phone');
});
