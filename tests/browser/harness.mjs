// What the browser specs are written with. A spec is a file tests/browser/*.spec.mjs that calls
// test(); run.mjs runs it in Chromium against build/web.
//
//   test('a circle becomes a part', {width: 360, height: 640}, async (app) => {
//     await app.draw(circle(180, 320, 100));
//     assert.equal(await app.page.evaluate(() => marrow.parts().length), 1);
//   });
//
// Every test has a page of its own, opened and ready, and fails when the page logs an error. All
// positions are CSS pixels from the top left corner.
import {mkdir, writeFile} from 'node:fs/promises';
import {createRequire} from 'node:module';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

// CommonJS packages are asked for by require: NODE_PATH counts there, and they need no build.
const {PNG} = createRequire(import.meta.url)('pngjs');

export const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
export const registered = [];

/// Registers a test. Options: width, height (CSS pixels), scale (device pixels per CSS pixel),
/// touch (a touch screen), path (below the site's root, with query), ready (false: do not wait for
/// marrow.ready), init (a function that runs in the page before its own scripts).
export function test(name, options, run) {
  if (run === undefined) [options, run] = [{}, options];
  registered.push({name, options, run});
}

/// n points of a circle, y down, from its right end; not closed.
export function circle(x, y, radius, n = 48) {
  return Array.from({length: n}, (_, i) => [x + radius * Math.cos(2 * Math.PI * i / n),
                                            y + radius * Math.sin(2 * Math.PI * i / n)]);
}

/// The points with others between them, so that none is further than `step` from the next.
export function dense(points, step = 8) {
  const result = [points[0]];
  for (let i = 1; i < points.length; ++i) {
    const [[ax, ay], [bx, by]] = [points[i - 1], points[i]];
    const n = Math.max(1, Math.ceil(Math.hypot(bx - ax, by - ay) / step));
    for (let k = 1; k <= n; ++k) result.push([ax + (bx - ax) * k / n, ay + (by - ay) * k / n]);
  }
  return result;
}

/// One test's page and the hands of its user.
export class App {
  constructor(page, session, address, label) {
    Object.assign(this, {page, session, address, label});
    this.errors = [];
    page.on('console', (message) => {
      if (message.type() === 'error') this.errors.push(message.text());
    });
    page.on('pageerror', (error) => this.errors.push(String(error)));
  }

  /// Opens the page, and waits until the app can be drawn on.
  async open({path = '', ready = true} = {}) {
    await this.page.goto(this.address + path);
    if (ready) await this.ready();
  }

  async ready() {
    await this.page.waitForFunction(() => window.marrow?.ready, null, {timeout: 60_000});
    await this.page.evaluate(() => window.marrow.ready.then(() => {}));
    await this.frames(2);
  }

  /// Lets n frames go by.
  async frames(n = 2) {
    await this.page.evaluate((count) => new Promise((done) => {
      const step = () => (count-- > 0 ? requestAnimationFrame(step) : done());
      step();
    }), n);
  }

  /// Waits until fn(argument), called in the page, is true.
  async until(fn, argument, timeout = 20_000) {
    await this.page.waitForFunction(fn, argument, {timeout, polling: 50});
  }

  /// Draws with the mouse. before(): called while the button is still down.
  async draw(points, {button = 'left', before} = {}) {
    const {mouse} = this.page;
    await mouse.move(...points[0]);
    await mouse.down({button});
    for (const point of points.slice(1)) await mouse.move(...point);
    if (before) await before();
    await mouse.up({button});
    await this.frames();
  }

  /// Draws with a pen; pressure: 0 … 1, or a function of the point's index.
  async drawWithPen(points, {pressure = 0.5, before} = {}) {
    const send = (type, i, buttons) => this.session.send('Input.dispatchMouseEvent', {
      type, x: points[i][0], y: points[i][1], button: 'left', buttons, pointerType: 'pen',
      clickCount: 1, force: typeof pressure === 'function' ? pressure(i) : pressure,
    });
    await send('mousePressed', 0, 1);
    for (let i = 1; i < points.length; ++i) await send('mouseMoved', i, 1);
    if (before) await before();
    await send('mouseReleased', points.length - 1, 0);
    await this.frames();
  }

  /// Moves fingers at the same time: one list of points a finger, all of the same length.
  async touch(fingers, {before} = {}) {
    const send = (type, touchPoints) =>
        this.session.send('Input.dispatchTouchEvent', {type, touchPoints});
    const at = (i) => fingers.map((points, id) => ({x: points[i][0], y: points[i][1], id}));
    await send('touchStart', at(0));
    for (let i = 1; i < fingers[0].length; ++i) await send('touchMove', at(i));
    if (before) await before();
    await send('touchEnd', []);
    await this.frames();
  }

  /// What is on the screen: at(x, y) is [r, g, b] at a CSS pixel.
  async pixels() {
    const image = PNG.sync.read(await this.page.screenshot({scale: 'device'}));
    const scale = image.width / this.page.viewportSize().width;
    const at = (x, y) => {
      const i = 4 * (Math.floor(y * scale) * image.width + Math.floor(x * scale));
      return [...image.data.subarray(i, i + 3)];
    };
    return {width: image.width, height: image.height, scale, data: image.data, at};
  }

  /// Keeps a picture to look at: build/screenshots/<spec>-<name>.png.
  async screenshot(name) {
    const file = join(root, 'build/screenshots', `${this.label}-${name}.png`);
    await mkdir(dirname(file), {recursive: true});
    await writeFile(file, await this.page.screenshot({scale: 'device'}));
    return file;
  }
}
