// Fingers and pens.
import assert from 'node:assert/strict';

import {circle, closed, dense, isBody, test} from './harness.mjs';

const ring = (x, y, radius) => dense(closed(circle(x, y, radius)), 10);
const near = (a, b, tolerance, what) =>
  assert.ok(Math.abs(a - b) <= tolerance, `${what}: ${a} is not ${b} ± ${tolerance}`);
const tablet = {width: 800, height: 600, touch: true};

/// From one place to another in n steps.
const path = (from, to, n = 12) => Array.from({length: n + 1}, (_, i) =>
    [from[0] + (to[0] - from[0]) * i / n, from[1] + (to[1] - from[1]) * i / n]);

async function pageStands(app) {
  const page = await app.page.evaluate(() => [visualViewport.scale, visualViewport.offsetLeft,
    visualViewport.offsetTop, scrollX, scrollY, innerWidth, innerHeight]);
  assert.deepEqual(page, [1, 0, 0, 0, 0, 800, 600]);
}

test('one finger draws, and the part is there before it is lifted', tablet, async (app) => {
  await app.touch([ring(400, 300, 120)], {
    async before() {
      await app.until(() => marrow.stats().preview.part?.vertices > 0);
      assert.ok(isBody((await app.pixels()).at(400, 230)));
    },
  });
  assert.equal((await app.parts()).length, 1);
  await pageStands(app);
});

test('two fingers pinch, move and twist', tablet, async (app) => {
  await app.touch([ring(400, 300, 80)]);
  await app.key('Escape');  // its panel is where a finger will be
  const text = await app.document();
  const camera = async () => (await app.stats()).camera;
  const start = await camera();

  await app.touch([path([350, 300], [300, 300]), path([450, 300], [500, 300])]);
  const pinched = await camera();
  near(pinched.zoom / start.zoom, 2, 1e-6, 'zoom');
  near(pinched.yaw, 0, 1e-9, 'a pinch does not turn');
  await pageStands(app);

  await app.touch([path([350, 300], [400, 340]), path([450, 300], [500, 340])]);
  const moved = await camera();
  near(moved.zoom, pinched.zoom, 1e-6, 'zoom');
  near((pinched.target[0] - moved.target[0]) * moved.zoom, 50, 1e-6, 'x');
  near((moved.target[1] - pinched.target[1]) * moved.zoom, 40, 1e-6, 'y');

  const arc = (from) => Array.from({length: 13}, (_, i) => {
    const angle = from + i * Math.PI / 36;
    return [400 + 100 * Math.cos(angle), 300 + 100 * Math.sin(angle)];
  });
  await app.touch([arc(0), arc(Math.PI)]);
  const twisted = await camera();
  assert.ok(Math.abs(twisted.yaw) > 0.5, `yaw ${twisted.yaw}`);
  await pageStands(app);
  assert.equal(await app.document(), text);
});

test('a second finger ends a stroke that has just begun, and not one under way', tablet,
     async (app) => {
  const young = [[300, 300], [305, 302], [310, 305], [310, 305], [300, 300], [280, 290]];
  const second = [null, null, null, [500, 300], [520, 300], [560, 300]];
  await app.touch([young, second]);
  assert.equal((await app.parts()).length, 0);
  const {message, camera} = await app.stats();
  assert.equal(message, null);
  assert.ok(camera.zoom > 1, 'it pinched');

  // The same while a stroke is old enough to be meant.
  const outline = ring(400, 300, 120);
  const send = (type, touchPoints) =>
      app.session.send('Input.dispatchTouchEvent', {type, touchPoints});
  const finger = (i) => ({x: outline[i][0], y: outline[i][1], id: 0});
  const palm = {x: 700, y: 550, id: 1};
  const half = outline.length >> 1;
  await send('touchStart', [finger(0)]);
  await Promise.all(path([1, 0], [half, 0], half - 1)
      .map(([i]) => send('touchMove', [finger(i)])));
  const begun = await app.page.evaluate(() => performance.now());
  await app.until((time) => performance.now() > time + 260, begun);
  await send('touchStart', [finger(half), palm]);
  for (let i = half + 1; i < outline.length; i += 4) await send('touchMove', [finger(i), palm]);
  await send('touchEnd', [palm]);
  await send('touchEnd', []);
  await app.settled();
  assert.equal((await app.parts()).length, 1);
  assert.equal((await app.stats()).camera.zoom, camera.zoom);
  await pageStands(app);
});

test('a stroke that the system takes away leaves nothing', tablet, async (app) => {
  const send = (type, touchPoints) =>
      app.session.send('Input.dispatchTouchEvent', {type, touchPoints});
  await send('touchStart', [{x: 400, y: 200, id: 0}]);
  await Promise.all(ring(300, 200, 100).map(([x, y]) => send('touchMove', [{x, y, id: 0}])));
  await send('touchCancel', []);
  await app.settled();
  assert.equal((await app.parts()).length, 0);
  assert.equal((await app.stats()).message, null);
  assert.ok(!isBody((await app.pixels()).at(300, 150)));
});

test('a pen draws with all its samples, and the hand beside it does not', tablet, async (app) => {
  await app.page.evaluate(() => {
    window.seen = [];
    document.getElementById('canvas').addEventListener('pointermove', (event) => {
      for (const sample of event.getCoalescedEvents()) {
        window.seen.push([sample.pointerType, sample.pressure]);
      }
    });
  });
  const outline = ring(400, 300, 120);
  await app.draw(outline, {
    pointerType: 'pen', pressure: (i) => 0.2 + 0.6 * i / outline.length,
    async before() {
      const palm = [{x: 600, y: 500, id: 5}];
      await app.session.send('Input.dispatchTouchEvent', {type: 'touchStart', touchPoints: palm});
      await app.session.send('Input.dispatchTouchEvent', {type: 'touchEnd', touchPoints: []});
      assert.equal((await app.stats()).preview.active, true);
    },
  });
  const seen = (await app.page.evaluate(() => window.seen)).filter(([kind]) => kind === 'pen');
  const held = seen.filter(([, pressure]) => pressure > 0);
  assert.ok(held.length > 0.8 * outline.length, `${held.length} of ${outline.length} pen samples`);
  assert.ok(Math.max(...held.map(([, p]) => p)) > Math.min(...held.map(([, p]) => p)) + 0.3);
  assert.equal((await app.parts()).length, 1);
  const {parts: [{stroke}]} = await app.page.evaluate(() => marrow.document());
  assert.ok(stroke.points.length > 0.8 * outline.length);
});

test('a trackpad pinches without zooming the page', tablet, async (app) => {
  await app.page.mouse.move(400, 300);
  await app.page.keyboard.down('Control');
  await app.page.mouse.wheel(0, -50);
  await app.page.keyboard.up('Control');
  await app.until(() => marrow.stats().camera.zoom > 1.2);
  await app.page.mouse.wheel(60, 20);
  await app.until(() => marrow.stats().camera.target[0] !== 0);
  await pageStands(app);
});
