// Looking at it: camera, sizes, densities, a lost context, and rest.
import assert from 'node:assert/strict';

import {circle, closed, dense, differing, isBody, test} from './harness.mjs';

const canvas = [230, 70, 980, 730];  // free of panels at 1280×800
const ring = (x, y, radius) => dense(closed(circle(x, y, radius)), 10);
const near = (a, b, tolerance, what = '') =>
  assert.ok(Math.abs(a - b) <= tolerance, `${what} ${a} is not ${b} ± ${tolerance}`);

/// A bar of 400×100 in the middle of the canvas.
const bar = dense([[440, 350], [840, 350], [840, 450], [440, 450], [440, 350]], 10);

async function span(app) {
  await app.page.mouse.move(620, 20);  // hovers over nothing
  await app.settled();
  const {left, right, top, bottom, count} = (await app.pixels()).find(isBody, canvas);
  return {width: right - left, height: bottom - top, x: (left + right) / 2, y: (top + bottom) / 2,
          count};
}

test('keys and buttons turn to the front, the right and the top', {smooth: true}, async (app) => {
  await app.draw(bar);
  await app.key('Escape');
  const front = await span(app);
  near(front.width, 400, 12);
  near(front.height, 100, 12);
  await app.key('3');
  assert.equal((await app.stats()).camera.view, 'right');
  const right = await span(app);
  near(right.width, right.height, 12, 'a tube is as thick as it is wide:');
  near(right.width, 100, 16);
  await app.key('7');
  assert.equal((await app.stats()).camera.view, 'top');
  const top = await span(app);
  near(top.width, 400, 12);
  near(top.height, 100, 16);
  await app.key('1');
  const again = await span(app);
  near(again.count, front.count, 0.01 * front.count);
  for (const id of ['right', 'top', 'front']) {
    await app.press('views', id);
    assert.equal((await app.stats()).camera.view, id);
  }
  await app.drag([400, 600], [500, 640], {button: 'right'});
  assert.equal((await app.stats()).camera.view, null);
});

test('the mouse turns, zooms and moves the view, and one draws as it is turned', async (app) => {
  await app.draw(bar);
  await app.key('Escape');
  const start = (await app.stats()).camera;
  const text = await app.document();

  // The wheel keeps what is under the pointer there, and back is where it was.
  await app.page.mouse.move(440, 400);
  await app.page.mouse.wheel(0, -300);
  await app.until(() => marrow.stats().camera.zoom > 1.3);
  await app.settled();
  const zoomed = (await app.stats()).camera;
  near(zoomed.target[0] + (440 - 640) / zoomed.zoom, -200, 1e-6);
  await app.page.mouse.wheel(0, 300);
  await app.until(() => marrow.stats().camera.zoom < 1.3);
  await app.settled();
  near((await app.stats()).camera.zoom, start.zoom, 1e-9);

  // The middle button moves the model with the pointer.
  const before = await span(app);
  await app.drag([300, 600], [380, 550], {button: 'middle'});
  const moved = await span(app);
  near(moved.x - before.x, 80, 2);
  near(moved.y - before.y, -50, 2);

  // The right button turns about the model: its middle stays.
  await app.drag([600, 600], [690, 560], {button: 'right'});
  const {camera: turned} = await app.stats();
  assert.ok(Math.abs(turned.yaw) > 0.4 && Math.abs(turned.pitch) > 0.2, JSON.stringify(turned));
  const seen = await span(app);
  near(seen.x, moved.x, 20);
  near(seen.y, moved.y, 20);
  assert.ok(seen.width < moved.width - 40, 'foreshortened');
  await app.screenshot('turned');
  assert.equal(await app.document(), text, 'looking changes nothing');

  // A stroke from there faces the viewer there, where the hand went.
  await app.draw(ring(500, 620, 60));
  const {camera} = await app.stats();
  near(camera.yaw, turned.yaw, 1e-12);
  near(camera.pitch, turned.pitch, 1e-12);
  assert.ok(isBody((await app.pixels()).at(535, 620)), 'drawn under the hand');
  const {parts: [, {frame}]} = await app.page.evaluate(() => marrow.document());
  near(frame.x[0], Math.cos(turned.yaw), 1e-9);
  near(frame.y[1], Math.cos(turned.pitch), 1e-9);
  await app.key('f');
  await app.key('Escape');
  const all = await span(app);
  assert.ok(all.count > 1000 && all.width <= 1280 && all.height <= 800);
});

test('a window of another size shows the same, whole and sharp', async (app) => {
  await app.draw(bar);
  for (const [width, height] of [[900, 600], [500, 700], [1280, 800]]) {
    await app.page.setViewportSize({width, height});
    await app.until((w) => marrow.stats().canvas.width === w, width);
    await app.settled();
    const size = await app.page.evaluate(() => {
      const {width, height} = document.getElementById('canvas');
      return [width, height];
    });
    assert.deepEqual(size, [width, height]);
    const pixels = await app.pixels();
    assert.ok(isBody(pixels.at(width / 2, height / 2 - 30)), `the part at ${width}×${height}`);
    for (const {id, x, y, width: w, height: h} of (await app.stats()).widgets) {
      assert.ok(x >= 0 && y >= 0 && x + w <= width && y + h <= height, `${id} is off the window`);
    }
  }
});

test('two device pixels for each of the page make a canvas twice as fine', {
  width: 800, height: 600, scale: 2,
}, async (app) => {
  await app.draw(ring(400, 300, 100));
  const size = await app.page.evaluate(() => {
    const {width, height} = document.getElementById('canvas');
    return {width, height, dpr: marrow.stats().dpr, pixels: marrow.stats().canvas};
  });
  assert.deepEqual(size, {width: 1600, height: 1200, dpr: 2,
    pixels: {width: 800, height: 600, pixelWidth: 1600, pixelHeight: 1200}});
  const {left, right} = (await app.pixels()).find(isBody, [250, 250, 500, 350]);
  near((left + right) / 2, 400, 2);
  near(right - left, 200, 8);

  // Text: steep edges, and more than enlarged pixels.
  await app.screenshot('two-fold');
  const {x, y, width, height} = await app.widget('views', 'front');
  const pixels = await app.pixels();
  let steep = 0, single = 0;
  for (let row = Math.round(2 * (y - height / 2)); row < 2 * (y + height / 2); row += 2) {
    for (let column = Math.round(2 * (x - width / 2)); column < 2 * (x + width / 2); column += 2) {
      const green = (dx, dy) => pixels.at((column + dx) / 2, (row + dy) / 2)[1];
      if (Math.abs(green(0, 0) - green(1, 0)) > 90) ++steep;
      if (green(0, 0) !== green(0, 1) || green(0, 0) !== green(1, 0)) ++single;
    }
  }
  assert.ok(steep > 20 && single > 100, `${steep} steep edges, ${single} blocks with detail`);
});

test('a narrow screen has room for drawing and targets for fingers', {
  width: 360, height: 640, touch: true,
}, async (app) => {
  await app.screenshot('hint');
  const outline = ring(180, 300, 110);
  await app.touch([outline]);
  assert.equal((await app.parts()).length, 1);
  await app.screenshot('drawn');
  const check = async (what) => {
    const {widgets} = await app.stats();
    for (const {panel, id, x, y, width, height} of widgets) {
      assert.ok(x >= 0 && y >= 0 && x + width <= 360 && y + height <= 640, `${what}: ${id} is cut off`);
      assert.ok(width >= 43.9 && height >= 43.9 || id === 'name', `${what}: ${panel}/${id} is small`);
    }
  };
  await check('drawn');
  const tap = async (panel, id, index) => {
    const {x, y} = await app.widget(panel, id, index);
    await app.touch([[[x, y]]]);
  };
  for (const sheet of ['part', 'parts', 'view', 'help']) {
    await tap('lower bar', sheet);
    await check(sheet);
    await app.screenshot(`sheet-${sheet}`);
    await tap('lower bar', sheet);
  }
  await tap('lower bar', 'part');
  const {x, y, width} = await app.widget('part', 'thickness');
  await app.touch([dense([[x, y], [x + width / 4, y]], 10)]);
  const {thickness} = await app.page.evaluate(() => marrow.document().parts[0]);
  assert.ok(thickness > 1.3, `thickness ${thickness}`);
  await tap('toolbar', 'undo');
  assert.equal(await app.page.evaluate(() => marrow.document().parts[0].thickness), 1);
});

test('a lost WebGL context comes back with everything in it', {smooth: true}, async (app) => {
  await app.draw(ring(500, 400, 120));
  await app.draw(bar.map(([x, y]) => [x, y + 220]));
  await app.page.mouse.move(620, 20);
  await app.settled();
  const [picture, text] = [await app.pixels(), await app.document()];
  await app.page.evaluate(() => {
    window.loss = document.getElementById('canvas').getContext('webgl2')
        .getExtension('WEBGL_lose_context');
    window.loss.loseContext();
  });
  await app.until(() => marrow.stats().contextLosses === 1);
  await app.key('3');  // nobody is drawing: it must not hurt
  await app.page.evaluate(() => window.loss.restoreContext());
  await app.until(() => !document.getElementById('canvas').getContext('webgl2').isContextLost());
  await app.key('1');
  await app.frames();
  const restored = await app.pixels();
  const changed = differing(picture, restored);
  assert.ok(changed < 200, `${changed} pixels differ`);
  assert.equal(await app.document(), text);
  await app.draw(ring(800, 250, 80));
  assert.equal((await app.parts()).length, 3);
  assert.ok(isBody((await app.pixels()).at(840, 250)));
});

test('where nothing happens nothing is drawn', async (app) => {
  const rest = async (what) => {
    await app.page.mouse.move(620, 20);
    await app.until(() => marrow.stats().warm.done);
    await app.until(() => !marrow.stats().message);
    await app.settled();
    const frames = await app.page.evaluate(async () => {
      const before = marrow.stats().frames;
      await new Promise((done) => setTimeout(done, 300));
      return marrow.stats().frames - before;
    });
    assert.equal(frames, 0, what);
  };
  await rest('the hint is drawn');
  await app.draw(ring(500, 400, 120));
  await rest('a part is drawn');
  // Moving the mouse over the canvas changes nothing either.
  const before = (await app.stats()).frames;
  await app.page.mouse.move(630, 300);
  await app.page.mouse.move(640, 320);
  await app.settled();
  assert.equal((await app.stats()).frames, before);
});
