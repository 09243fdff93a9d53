// node pointer.test.mjs BUILD_FOLDER: a stroke drawn faster than frames come keeps its points.
import assert from 'node:assert/strict';
import {spawn, spawnSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';

const [build] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'marrow-pointer-'));
const env = {...process.env, XDG_DATA_HOME: folder};
const app = spawn(path.join(build, 'marrow-app'), ['--size', '1000x700'], {env, stdio: 'inherit'});
const pause = (ms) => new Promise((done) => setTimeout(done, ms));
const xdotool = (...words) => {
  const done = spawnSync('xdotool', words.map(String), {encoding: 'utf8'});
  assert.equal(done.status, 0, `xdotool: ${done.error ?? done.stderr}`);
  return done.stdout;
};
/// What fn gives once it gives something.
async function until(what, fn) {
  for (const end = Date.now() + 60_000; Date.now() < end; await pause(200)) {
    const found = fn();
    if (found) return found;
  }
  throw new Error(`waited in vain for ${what}`);
}
/// The parts of the drawing that was kept.
function keptParts() {
  const files = fs.readdirSync(folder, {recursive: true}).map((name) => path.join(folder, name))
      .filter((name) => name.endsWith('.json') && fs.statSync(name).isFile());
  for (const file of files) {
    try {
      const {parts} = JSON.parse(fs.readFileSync(file, 'utf8'));
      if (parts?.length) return parts;
    } catch { /* being written */ }
  }
  return null;
}

try {
  const [id] = (await until('the window', () => spawnSync('xdotool',
      ['search', '--onlyvisible', '--name', 'Marrow'], {encoding: 'utf8'}).stdout.trim())).split('\n');
  await pause(1500);  // the first frame is slow
  const place = Object.fromEntries(xdotool('getwindowgeometry', '--shell', id).trim().split('\n')
      .map((line) => line.split('=')));
  const [x, y] = [Number(place.X) + 500, Number(place.Y) + 330];
  const way = Array.from({length: 64}, (_, i) => [
    Math.round(x + 200 * Math.cos(2 * Math.PI * i / 64)),
    Math.round(y + 120 * Math.sin(2 * Math.PI * i / 64))]);
  xdotool('mousemove', ...way[0]);
  xdotool('mousedown', 1, ...way.flatMap((point) => ['mousemove', ...point]), 'mouseup', 1);
  const parts = await until('the kept drawing', keptParts);
  const {points} = parts[0].stroke;
  assert.ok(points.length > 0.8 * way.length, `${points.length} points of ${way.length}`);
  console.log(`ok      ${points.length} points of ${way.length}`);
} finally {
  app.kill('SIGKILL');
  fs.rmSync(folder, {recursive: true, force: true});
}
