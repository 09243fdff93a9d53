// Strokes that become parts under the hand.
import assert from 'node:assert/strict';

import {circle, closed, dense, differing, isBody, test} from './harness.mjs';

const canvas = [230, 70, 980, 730];  // free of panels at 1280×800
const ring = (x, y, radius) => dense(closed(circle(x, y, radius)), 6);

// An animal seen from the side, about 320×240 pixels.
const animal = [[0, 0], [-40, -60], [-30, -100], [0, -70], [60, -60], [200, -60], [250, -110],
                [290, -90], [270, -40], [250, 30], [240, 120], [205, 120], [200, 40], [80, 40],
                [75, 120], [40, 120], [35, 40]];
const creature = (x, y) => dense(closed(animal.map(([dx, dy]) => [x + dx, y + dy])), 6);

function isTree(joints, bones) {
  const root = joints.map((_, i) => i);
  const find = (i) => (root[i] === i ? i : find(root[i]));
  for (const [a, b] of bones) root[find(a)] = find(b);
  return bones.length === joints.length - 1 && new Set(joints.map((_, i) => find(i))).size === 1;
}

test('a stroke is a body with bones before the button goes up, and stays where it was drawn',
     async (app) => {
  const before = await app.pixels();
  let live, livePixels;
  await app.draw(creature(500, 380), {
    async before() {
      await app.until(() => marrow.stats().preview.part?.bones > 0);
      live = (await app.stats()).preview;
      livePixels = await app.pixels();
      await app.screenshot('live');
    },
  });
  assert.equal(live.active, true);
  assert.ok(live.part.vertices > 50 && live.part.triangles > 100);
  assert.ok(before.find(isBody, canvas).count < 300, 'the hint alone');
  assert.ok(livePixels.find(isBody, canvas).count > 15_000, 'the body under the pen');

  const parts = await app.parts();
  assert.equal(parts.length, 1);
  const [{joints, bones, mesh, timings, straightSkeleton}] = parts;
  assert.ok(isTree(joints, bones), 'the bones are a tree');
  assert.ok(joints.filter((joint) => joint.kind === 'terminal').length >= 4, 'head, tail, legs');
  assert.ok(joints.some((joint) => joint.kind === 'junction'));
  assert.ok(joints.every(({position, radius}) => position.length === 3 && radius > 0));
  assert.ok(mesh.triangles >= live.part.triangles, 'the finished part is finer');
  assert.equal(straightSkeleton.method, 'wavefront');
  assert.ok(timings.total >= 0 && 'outline' in timings && 'inflation' in timings);

  const after = await app.pixels();
  await app.screenshot('drawn');
  const silhouette = after.find(isBody, canvas);
  // The stroke spans 460 … 790 × 270 … 500; the rim lies half outside.
  assert.ok(Math.abs(silhouette.left - 460) < 5 && Math.abs(silhouette.right - 790) < 5,
            JSON.stringify(silhouette));
  assert.ok(Math.abs(silhouette.top - 270) < 5 && Math.abs(silhouette.bottom - 500) < 5,
            JSON.stringify(silhouette));
  // The bones are on top, and only the bones go when they are switched off.
  await app.press('switches', 'bones');
  assert.equal((await app.stats()).show.bones, false);
  const boneless = await app.pixels();
  assert.ok(boneless.find(isBody, canvas).count > silhouette.count + 300, 'grey bones hid the body');
  for (const [x, y] of [[540, 370], [556, 480], [720, 480], [770, 300]]) {
    assert.ok(isBody(boneless.at(x, y)), `inside at ${x}, ${y}: ${boneless.at(x, y)}`);
  }
  for (const [x, y] of [[640, 450], [600, 290], [440, 380], [830, 400]]) {
    assert.ok(!isBody(boneless.at(x, y)), `outside at ${x}, ${y}: ${boneless.at(x, y)}`);
  }
  await app.press('switches', 'bones');
});

test('every way of looking at a part changes the picture', async (app) => {
  await app.draw(creature(500, 380));
  await app.page.mouse.move(600, 780);
  let last = await app.pixels();
  for (const id of ['wireframe', 'straightSkeleton', 'proxy', 'mesh']) {
    await app.press('switches', id);
    await app.page.mouse.move(600, 780);
    await app.settled();
    const next = await app.pixels();
    const changed = differing(last, next);
    assert.ok(changed > 800, `${id}: ${changed} pixels`);
    last = next;
  }
  const {show} = await app.stats();
  assert.deepEqual(show, {mesh: false, wireframe: true, bones: true, straightSkeleton: true,
                          proxy: true});
  await app.screenshot('all-switches');
});

test('a stroke over a panel, a dot, a line and a scribble leave no nonsense behind', async (app) => {
  const {x, y} = await app.widget('toolbar', 'new');
  await app.draw(dense([[x, y], [500, 300], [700, 300], [600, 500]]));
  assert.equal((await app.parts()).length, 0, 'begun on the toolbar');
  assert.equal((await app.stats()).message, null);

  const empty = await app.document();
  const refused = async (points, what) => {
    await app.draw(points);
    const {message} = await app.stats();
    assert.match(message ?? '', /^[A-Z][^.]*\.( [A-Z][^.]*\.)?$/, `${what}: ${message}`);
    assert.equal(await app.document(), empty, what);
  };
  await refused([[640, 400], [640, 400]], 'a click');
  await refused([[640, 400], [645, 401], [647, 404]], 'a dot');
  await refused(dense([[400, 400], [900, 400]]), 'a straight line');
  await refused(dense([[400, 400], [900, 400], [400, 400]]), 'there and back');
  assert.equal(await app.page.evaluate(() => marrow.undo()), false, 'nothing to undo');

  const scribble = Array.from({length: 400}, (_, i) => i + 1).map((i) =>
      [600 + 220 * Math.sin(i * 1.7) * Math.cos(i * 0.013),
       400 + 200 * Math.cos(i * 2.3 + Math.sin(i))]);
  await app.draw(scribble);
  const [part] = await app.parts();
  assert.equal(part.error, undefined);
  assert.ok(isTree(part.joints, part.bones));
});

test('a stroke that begins on the button of the empty canvas is a stroke', {width: 1280, height: 800},
     async (app) => {
  const {x, y} = await app.widget('start', 'samples');
  await app.draw(closed(dense([[x, y], [x - 150, y - 60], [x, y - 250], [x + 150, y - 60], [x, y]])));
  assert.equal((await app.parts()).length, 1);
});

test('a stroke of 20,000 samples is drawn to its end', {width: 720, height: 720}, async (app) => {
  // A wavy ring, 24,000 pixels long.
  const n = 20_000;
  const points = Array.from({length: n}, (_, i) => {
    const turn = 2 * Math.PI * i / n, wave = 150 * i / n;
    const radius = 160 + 160 * Math.abs(wave - Math.round(wave));
    return [360 + radius * Math.cos(turn), 360 + radius * Math.sin(turn)];
  });
  let sampled;
  await app.draw(points, {
    async before() {
      await app.frames(3);  // the last ones have been seen by the app
      sampled = (await app.stats()).preview.points;
    },
  });
  assert.ok(sampled > 19_000, `${sampled} samples arrived`);
  const [part] = await app.parts();
  assert.equal(part.error, undefined);
  assert.ok(part.joints.length > 1 && isTree(part.joints, part.bones));
  const {parts: [{stroke}]} = await app.page.evaluate(() => marrow.document());
  assert.equal(stroke.points.length, sampled);
});
