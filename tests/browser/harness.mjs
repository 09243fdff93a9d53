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
import {mkdir, readFile, writeFile} from 'node:fs/promises';
import {createRequire} from 'node:module';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

// CommonJS packages are asked for by require: NODE_PATH counts there, and they need no build.
const {PNG} = createRequire(import.meta.url)('pngjs');

export const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
export const registered = [];

/// Registers a test. Options: width, height (CSS pixels), scale (device pixels per CSS pixel),
/// touch (a touch screen), path (below the site's root, with query), ready (false: do not wait for
/// marrow.ready), init (a function that runs in the page before its own scripts), prepare (a
/// function that is given the App before it opens the page).
export function test(name, options, run) {
  if (run === undefined) [options, run] = [{}, options];
  registered.push({name, options, run});
}

/// n points of a circle, y down, from its right end; not closed.
export function circle(x, y, radius, n = 48) {
  return Array.from({length: n}, (_, i) => [x + radius * Math.cos(2 * Math.PI * i / n),
                                            y + radius * Math.sin(2 * Math.PI * i / n)]);
}

/// The points and the way back to the first one.
export function closed(points) { return [...points, points[0]]; }

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

/// A colour that only a part has: background, shadow and bones are grey.
export function isBody([r, g, b]) { return Math.max(r, g, b) - Math.min(r, g, b) > 40; }

/// How many pixels differ between two pictures.
export function differing(a, b) {
  let found = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    found += [0, 1, 2].some((k) => Math.abs(a.data[i + k] - b.data[i + k]) > 8);
  }
  return found;
}

/// One test's page and the hands of its user.
export class App {
  constructor(page, session, address, label) {
    Object.assign(this, {page, session, address, label});
    this.errors = [];
    this.requests = [];
    page.on('request', (request) => this.requests.push(request.url()));
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

  /// Fails at once where the page's scripts do.
  async ready() {
    const broken = new Promise((_, fail) => {
      if (this.errors.length) fail(new Error(this.errors.join('\n')));
      this.page.once('pageerror', fail);
    });
    const ready = this.until(() => Boolean(window.marrow?.ready), undefined, 60_000)
        .then(() => this.page.evaluate(() => marrow.ready.then(() => {})));
    await Promise.race([broken, ready]);
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

  stats() { return this.page.evaluate(() => marrow.stats()); }
  parts() { return this.page.evaluate(() => marrow.parts()); }
  /// The document's text, byte for byte what it would be saved as.
  document() { return this.page.evaluate(() => JSON.stringify(marrow.document())); }

  /// Waits until nothing moves and nothing is left to be drawn.
  async settled() {
    await this.until(() => {
      const {idle, camera, preview} = marrow.stats();
      return idle && !camera.moving && !preview.active;
    });
  }

  /// Sends mouse or pen events one after another without waiting for the page to answer each, which
  /// takes a frame: so they come as fast as from a real hand, several in one frame.
  mouse(events) {
    return Promise.all(events.map((event) => this.session.send('Input.dispatchMouseEvent', event)));
  }

  /// Draws with a mouse or a pen. before(): called while the button is still down. pressure: of a
  /// pen, 0 … 1, or a function of the point's index.
  async draw(points, {button = 'left', pointerType = 'mouse', pressure = 0.5, before} = {}) {
    const buttons = {left: 1, right: 2, middle: 4}[button];
    const event = (type, i, held) => ({
      type, x: points[i][0], y: points[i][1], button, buttons: held, pointerType, clickCount: 1,
      force: typeof pressure === 'function' ? pressure(i) : pressure,
    });
    await this.mouse([{...event('mouseMoved', 0, 0), button: 'none'},
                      event('mousePressed', 0, buttons)]);
    await this.mouse(points.slice(1).map((_, i) => event('mouseMoved', i + 1, buttons)));
    if (before) await before();
    await this.mouse([event('mouseReleased', points.length - 1, 0)]);
    await this.settled();
  }

  drag(from, to, options) { return this.draw(dense([from, to], 20), options); }

  async click(x, y) {
    await this.page.mouse.click(x, y);
    await this.settled();
  }

  async key(name) {
    await this.page.keyboard.press(name);
    await this.settled();
  }

  /// Moves fingers at the same time: one list of points a finger, all of the same length. A finger
  /// that comes down later has null at first.
  async touch(fingers, {before} = {}) {
    const send = (type, touchPoints) =>
        this.session.send('Input.dispatchTouchEvent', {type, touchPoints});
    const at = (i) => fingers.map((points, id) => points[i] && {x: points[i][0], y: points[i][1], id})
        .filter(Boolean);
    const events = [];
    for (let i = 0; i < fingers[0].length; ++i) {
      const grows = i === 0 || at(i).length > at(i - 1).length;
      events.push(send(grows ? 'touchStart' : 'touchMove', at(i)));
    }
    await Promise.all(events);
    if (before) await before();
    await send('touchEnd', []);
    await this.settled();
  }

  /// Where a control of a panel is: its middle and size. index: among those of the same id.
  async widget(panel, id, index = 0) {
    const places = (await this.stats()).widgets
        .filter((one) => one.panel === panel && one.id === id);
    if (!places[index]) throw new Error(`there is no ${id} in the panel ${panel}`);
    const {x, y, width, height} = places[index];
    return {x: x + width / 2, y: y + height / 2, width, height};
  }

  async press(panel, id, index = 0) {
    const {x, y} = await this.widget(panel, id, index);
    await this.click(x, y);
  }

  /// Does something that downloads a file.
  async downloaded(act) {
    const [download] = await Promise.all([this.page.waitForEvent('download'), act()]);
    await this.settled();
    return {name: download.suggestedFilename(), bytes: await readFile(await download.path())};
  }

  /// What is on the screen: at(x, y) is [r, g, b] at a CSS pixel.
  async pixels() {
    const image = PNG.sync.read(await this.page.screenshot({scale: 'device'}));
    const scale = image.width / this.page.viewportSize().width;
    const at = (x, y) => {
      const i = 4 * (Math.floor(y * scale) * image.width + Math.floor(x * scale));
      return [...image.data.subarray(i, i + 3)];
    };
    // Of the pixels in a box (left, top, right, bottom), those that are so, and what they span.
    const find = (is, [left, top, right, bottom]) => {
      const found = {count: 0, left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity};
      for (let y = Math.round(top * scale); y < bottom * scale; ++y) {
        for (let x = Math.round(left * scale); x < right * scale; ++x) {
          const i = 4 * (y * image.width + x);
          if (!is(image.data.subarray(i, i + 3))) continue;
          ++found.count;
          found.left = Math.min(found.left, x / scale);
          found.right = Math.max(found.right, (x + 1) / scale);
          found.top = Math.min(found.top, y / scale);
          found.bottom = Math.max(found.bottom, (y + 1) / scale);
        }
      }
      return found;
    };
    return {width: image.width, height: image.height, scale, data: image.data, at, find};
  }

  /// Keeps a picture to look at: build/screenshots/<spec>-<name>.png.
  async screenshot(name) {
    const file = join(root, 'build/screenshots', `${this.label}-${name}.png`);
    await mkdir(dirname(file), {recursive: true});
    await writeFile(file, await this.page.screenshot({scale: 'device'}));
    return file;
  }
}
