// node same_part.test.mjs NATIVE WASM.js CREATURES [FOLDER WITH strokes/]: the command line, natively and as
// WebAssembly, makes the same part of a stroke: the same joints, bones and triangles, coordinates
// to 1e-9 of the part's size.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {fileURLToPath} from 'node:url';

const kTolerance = 1e-9;
const [native, wasm, , shared] = process.argv.slice(2);
const runner = path.join(path.dirname(fileURLToPath(import.meta.url)), 'run.cjs');
const programs = {native: [native], wasm: [process.execPath, runner, wasm]};
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'marrow-same-'));

// Integers to doubles exactly: the same strokes on every machine.
function random(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

function polar(n, radius, turns = 1) {
  return Array.from({length: n}, (_, i) => {
    const t = i / n;
    const angle = 2 * Math.PI * turns * t;
    const r = typeof radius === 'function' ? radius(t) : radius;
    return [r * Math.cos(angle), r * Math.sin(angle)];
  });
}

function spiral(turns, n) {
  const arm = (offset) => Array.from({length: n}, (_, i) => {
    const angle = 2 * Math.PI * turns * i / (n - 1);
    const r = 20 + 14 * angle + offset;
    return [r * Math.cos(angle), r * Math.sin(angle)];
  });
  return [...arm(-14), ...arm(14).reverse()];
}

function hand() {
  const outline = [[-60, -150], [-70, -40]];
  for (let finger = 0; finger < 4; ++finger) {
    const x = -65 + 36 * finger;
    const top = [60, 90, 85, 50][finger];
    outline.push([x, 0], [x - 6, top], [x + 8, top + 14], [x + 22, top], [x + 26, 0]);
  }
  return [...outline, [70, -40], [120, 0], [140, -14], [90, -80], [60, -150]];
}

function scribble(seed, n) {
  const next = random(seed);
  let [x, y, angle] = [0, 0, 0];
  return Array.from({length: n}, () => {
    angle += (next() - 0.5) * 1.5;
    x += 9 * Math.cos(angle);
    y += 9 * Math.sin(angle);
    return [x, y];
  });
}

const strip = [[-200, -10], [200, -10], [200, 10], [-200, 10]];
const star = polar(10, (t) => (Math.round(t * 10) % 2 ? 60 : 160));
const wobbly = (seed, n) => {
  const next = random(seed);
  const [a, b, c] = [next(), next(), next()];
  return polar(n, (t) => 120 + 40 * Math.sin(6 * Math.PI * (t + a)) +
      30 * Math.cos(10 * Math.PI * (t + b)) + 2 * next() * c);
};
const times = (points, factor) => points.map(([x, y]) => [factor * x, factor * y]);

function ownStrokes() {
  const strokes = {
    disc: polar(200, 100), 'disc of 12': polar(12, 100), strip, star, hand: hand(),
    triangle: [[0, 0], [90, 10], [20, 70]], square: [[0, 0], [80, 0], [80, 80], [0, 80]],
    spiral: spiral(3, 150), 'figure of eight': polar(90, (t) => 100 * Math.cos(2 * Math.PI * t)),
    'tiny hand': times(hand(), 1e-6), 'huge hand': times(hand(), 1e9),
    'far away': star.map(([x, y]) => [x + 1e6, y - 3e6]),
    'an open arc': polar(80, 150).slice(0, 60), 'many samples': polar(20_000, 300),
  };
  for (const seed of [1, 2, 3]) strokes[`scribble ${seed}`] = scribble(seed, 300);
  for (const seed of [4, 5, 6, 7]) strokes[`wobbly ${seed}`] = wobbly(seed, 60 * (seed - 3));
  return Object.entries(strokes).map(([name, points]) => {
    const file = path.join(folder, `${name}.json`);
    fs.writeFileSync(file, JSON.stringify({name, closed: true, points}));
    return [name, file];
  });
}

function realStrokes() {
  const from = shared ? path.join(shared, 'strokes') : '';
  if (!from || !fs.existsSync(from)) {
    console.log('No real strokes here: only our own are compared.');
    return [];
  }
  return fs.readdirSync(from).filter((name) => name.endsWith('.json')).sort()
      .map((name) => [name, path.join(from, name)]);
}

function partBy([command, ...words], stroke) {
  const [json, obj] = ['part.json', 'part.obj'].map((name) => path.join(folder, name));
  for (const file of [json, obj]) fs.rmSync(file, {force: true});
  const done = spawnSync(command, [...words, 'part', stroke, '--json', json, '--obj', obj],
      {encoding: 'utf8'});
  assert.equal(done.status, 0, `${command}: ${done.stderr}`);
  const lines = fs.readFileSync(obj, 'utf8').split('\n');
  const rows = (word) => lines.filter((line) => line.startsWith(word + ' '))
      .map((line) => line.split(' ').slice(1));
  const part = JSON.parse(fs.readFileSync(json, 'utf8'));
  return {...part, vertices: rows('v').map((row) => row.map(Number)),
    normals: rows('vn').map((row) => row.map(Number)), faces: rows('f')};
}

/// The largest difference between two trees of numbers of the same form.
function difference(a, b, what) {
  if (!Array.isArray(a)) return Math.abs(a - b);
  assert.equal(a.length, b.length, `${what}: how many`);
  let largest = 0;
  a.forEach((one, i) => { largest = Math.max(largest, difference(one, b[i], what)); });
  return largest;
}

function compare(a, b) {
  const size = Math.max(...[0, 1].map((axis) => {
    const along = a.outline.map((point) => point[axis]);
    return Math.max(...along) - Math.min(...along);
  }));
  assert.ok(size > 0);
  // What is decided is the same …
  const decided = (part) => ({
    method: part.straightSkeleton.method, edges: part.straightSkeleton.edges,
    kinds: part.skeleton.joints.map((joint) => joint.kind), bones: part.skeleton.bones,
    mesh: {...part.mesh, volume: 0}, faces: part.faces,
  });
  assert.deepEqual(decided(b), decided(a));
  // … and what is measured nearly so; coordinates far from the origin have fewer digits.
  const far = Math.max(size, ...a.outline.flat().map(Math.abs));
  const measured = {
    outline: (part) => part.outline, polygon: (part) => part.polygon,
    nodes: (part) => part.straightSkeleton.nodes, vertices: (part) => part.vertices,
    joints: (part) => part.skeleton.joints.map((joint) => [...joint.position, joint.radius]),
  };
  let largest = 0;
  for (const [what, of] of Object.entries(measured)) {
    const error = difference(of(a), of(b), what) / far;
    assert.ok(error <= kTolerance, `${what}: ${error} of the size apart`);
    largest = Math.max(largest, error);
  }
  assert.ok(difference(a.normals, b.normals, 'normals') <= 1e-6, 'normals');
  assert.ok(Math.abs(a.mesh.volume - b.mesh.volume) <= kTolerance * size ** 3, 'volume');
  return largest;
}

let failed = 0;
const strokes = [...ownStrokes(), ...realStrokes()];
for (const [name, file] of strokes) {
  try {
    const apart = compare(partBy(programs.native, file), partBy(programs.wasm, file));
    console.log(`ok      ${name}: ${apart === 0 ? 'the same bits' : `${apart} of the size apart`}`);
  } catch (error) {
    ++failed;
    console.log(`FAILED  ${name}: ${error.message.split('\n').slice(0, 12).join('\n')}`);
  }
}
fs.rmSync(folder, {recursive: true});
console.log(`${strokes.length - failed} passed, ${failed} failed`);
process.exitCode = failed ? 1 : 0;
