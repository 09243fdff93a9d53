// node same_part.test.mjs BUILD_FOLDER [FOLDER WITH strokes/]: the desktop app, on a screen, makes
// the same parts of the same pointer samples as the app in Chromium, and shows them.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import {createRequire} from 'node:module';
import os from 'node:os';
import path from 'node:path';

import {serve} from '../../scripts/serve.mjs';
import {launch} from '../browser/chromium.mjs';
import {App, closed, dense, isBody, root} from '../browser/harness.mjs';

const {PNG} = createRequire(import.meta.url)('pngjs');
const [build, shared] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'marrow-desktop-'));
const [width, height] = [1280, 800];  // panels lie beside the middle

/// Whole pixels about the middle of the window, y up, at most 400 across.
function pixels(points) {
  const [xs, ys] = [points.map((p) => p[0]), points.map((p) => p[1])];
  const middle = [xs, ys].map((all) => (Math.min(...all) + Math.max(...all)) / 2);
  const span = Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys));
  const whole = points.map(([x, y]) => [Math.round(400 * (x - middle[0]) / span),
                                        Math.round(400 * (y - middle[1]) / span)]);
  return whole.filter(([x, y], i) => i === 0 || x !== whole[i - 1][0] || y !== whole[i - 1][1]);
}

function strokes() {
  const lizard = [[0, 0], [60, 30], [110, 90], [130, 80], [90, 20], [200, 10], [290, 40], [330, 10],
                  [280, -30], [200, -20], [100, -30], [130, -100], [105, -105], [60, -30],
                  [-120, -15], [-130, 0]];
  const all = {
    lizard: dense(closed(lizard), 5),
    'an open hook': dense([[-100, -100], [100, -100], [120, 0], [80, 100], [60, 0], [-80, -60]], 5),
  };
  const from = shared ? path.join(shared, 'strokes') : '';
  if (fs.existsSync(from)) {
    for (const name of ['ad-char1', 'icon-mdi-bat', 'qd-snake-529']) {
      const file = path.join(from, `${name}.json`);
      if (fs.existsSync(file)) all[name] = JSON.parse(fs.readFileSync(file, 'utf8')).points;
    }
  } else {
    console.log('No real strokes here: only our own are compared.');
  }
  return Object.entries(all).map(([name, points]) => [name, pixels(points)]);
}

function onDesktop(name, points) {
  const [stroke, dump, screenshot] = ['json', 'dump.json', 'png']
      .map((ending) => path.join(folder, `${name}.${ending}`));
  fs.writeFileSync(stroke, JSON.stringify({name, closed: true, points}));
  const done = spawnSync(path.join(build, 'marrow-app'), ['--size', `${width}x${height}`,
    '--play', stroke, '--dump', dump, '--screenshot', screenshot],
    {encoding: 'utf8', env: {...process.env, XDG_DATA_HOME: folder}});
  assert.equal(done.status, 0, `${done.error ?? done.stderr}`);
  assert.equal(done.stderr, '');
  return {parts: JSON.parse(fs.readFileSync(dump, 'utf8')),
    image: PNG.sync.read(fs.readFileSync(screenshot)), file: screenshot};
}

async function inBrowser(browser, address, points) {
  const context = await browser.newContext({viewport: {width, height}});
  const page = await context.newPage();
  const app = new App(page, await context.newCDPSession(page), address, 'desktop');
  await app.open();
  await app.draw(points.map(([x, y]) => [width / 2 + x, height / 2 - y]));
  const parts = await app.parts();
  await context.close();
  return parts;
}

function difference(a, b) {
  if (!Array.isArray(a)) return Math.abs(a - b);
  assert.equal(a.length, b.length);
  return Math.max(0, ...a.map((one, i) => difference(one, b[i])));
}

function compare(desktop, browser) {
  const decided = (parts) => parts.map(({id, bones, mesh, straightSkeleton, joints}) =>
      ({id, bones, mesh, straightSkeleton, kinds: joints.map((joint) => joint.kind)}));
  assert.deepEqual(decided(browser), decided(desktop));
  const measured = (parts) => parts.map(({joints}) =>
      joints.map(({position, radius}) => [...position, radius]));
  assert.ok(difference(measured(browser), measured(desktop)) < 1e-9 * 400);
}

/// The part is on the screen: its colour is where its joints are, the background beside it.
function checkImage(image, joints) {
  const scale = image.width / width;
  const near = (x, y, is) => {
    for (let dy = -8; dy <= 8; ++dy) {
      for (let dx = -8; dx <= 8; ++dx) {
        const [px, py] = [Math.round((width / 2 + x) * scale) + dx,
                          Math.round((height / 2 - y) * scale) + dy];
        const i = 4 * (py * image.width + px);
        if (is(image.data.subarray(i, i + 3))) return true;
      }
    }
    return false;
  };
  for (const {position: [x, y]} of joints) assert.ok(near(x, y, isBody), `nothing at ${x}, ${y}`);
  assert.ok(!near(-300, 250, isBody) && !near(0, -320, isBody), 'background');
}

const server = await serve(process.env.SITE ?? path.join(root, 'build/web'));
const browser = await launch();
let failed = 0;
for (const [name, points] of strokes()) {
  try {
    const {parts, image, file} = onDesktop(name, points);
    assert.equal(parts.length, 1);
    checkImage(image, parts[0].joints);
    compare(parts, await inBrowser(browser, server.address, points));
    fs.mkdirSync(path.join(root, 'build/screenshots'), {recursive: true});
    fs.copyFileSync(file, path.join(root, `build/screenshots/desktop-${name}.png`));
    console.log(`ok      ${name}: ${parts[0].joints.length} joints`);
  } catch (error) {
    ++failed;
    console.log(`FAILED  ${name}: ${error.message.split('\n').slice(0, 12).join('\n')}`);
  }
}
await browser.close();
await server.close();
fs.rmSync(folder, {recursive: true});
process.exitCode = failed ? 1 : 0;
