// node same_rig.test.mjs NATIVE WASM.js: the command line, natively and as WebAssembly, makes the
// same rig of a document, bit for bit: of random creatures and of the samples.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {fileURLToPath} from 'node:url';

const [native, wasm] = process.argv.slice(2);
const here = path.dirname(fileURLToPath(import.meta.url));
const programs = {native: [native], wasm: [process.execPath, path.join(here, 'run.cjs'), wasm]};
const samples = path.resolve(here, '../../public/samples');
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'marrow-same-'));

// Integers to doubles exactly, and + − × ÷ alone: the same creatures on every machine.
class Random {
  constructor(seed) { this.state = seed >>> 0; }
  unit() {
    this.state = (Math.imul(this.state, 1664525) + 1013904223) >>> 0;
    return this.state / 2 ** 32;
  }
  between(low, high) { return low + (high - low) * this.unit(); }
  below(count) { return Math.floor(this.unit() * count); }
  chance(often) { return this.unit() < often; }
}

/// The columns of a rotation, by a quaternion of small whole numbers.
function rotation(random) {
  const [w, x, y, z] = [1 + random.below(4), 0, 0, 0].map((first) => first || random.below(9) - 4);
  const n = w * w + x * x + y * y + z * z;
  return [[n - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
    [2 * (x * y - z * w), n - 2 * (x * x + z * z), 2 * (y * z + x * w)]]
      .map((column) => column.map((value) => value / n));
}

/// Points of the unit circle, counter-clockwise.
function circle(count) {
  const quarter = Math.max(2, count >> 2);
  return Array.from({length: 4 * quarter}, (_, i) => {
    const t = (i % quarter) / quarter;
    let [x, y] = [(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)];
    for (let turn = Math.floor(i / quarter); turn > 0; --turn) [x, y] = [-y, x];
    return [x, y];
  });
}

/// A lump, a star with soft arms, a bent limb, or a scribble that crosses itself.
function shape(random, size) {
  const points = circle(24 + random.below(80));
  const kind = random.below(7), [a, b, c] = [0, 1, 2].map(() => random.between(-0.4, 0.4));
  return points.map(([x, y]) => {
    const wobble = 1 + random.between(-0.02, 0.02);
    if (kind < 2) return [x * size * wobble, y * size * (0.8 + a) * wobble];
    if (kind === 2) {
      const r = size * (0.7 + 0.3 * (x ** 4 - 6 * x * x * y * y + y ** 4)) * wobble;
      return [x * r, y * r];
    }
    if (kind === 3) return [size * x * wobble, size * x * y * (1 + a)];
    return [size * x * wobble, size * (y * (0.25 + b / 3) * (1 + a * x) + c * x * x)];
  });
}

function creature(seed) {
  const random = new Random(seed);
  const parts = [];
  const count = 2 + (seed % 12 === 0 ? 58 : random.below(seed % 3 === 0 ? 30 : 9));
  const place = (part, [x, y]) =>
    part.frame.origin.map((o, i) => o + part.frame.x[i] * x + part.frame.y[i] * y);
  for (let i = 0; i < count; ++i) {
    const [x, y] = random.chance(0.4) ? [[1, 0, 0], [0, 1, 0]] : rotation(random);
    const scale = random.between(0.5, 1.5);
    const part = {
      id: `part-${i + 1}`, name: random.chance(0.3) ? 'Leg' : `Part ${i + 1}`,
      stroke: {points: shape(random, i === 0 ? 150 : random.between(25, 110))},
      frame: {origin: [0, 0, 0], x: x.map((v) => v * scale), y: y.map((v) => v * scale)},
      thickness: random.between(0.4, 1.6), color: '#88ccee',
    };
    if (i > 0) {  // begins inside an earlier one, but for a few
      const parent = parts[random.below(i)];
      const border = parent.stroke.points[random.below(parent.stroke.points.length)];
      const inside = place(parent, border.map((v) => v * random.between(0.2, 0.9)));
      const start = place(part, part.stroke.points[0].map((v) => v * 0.9));
      part.frame.origin = inside.map((v, k) => v - start[k]);
      if (random.chance(0.1)) part.frame.origin[random.below(3)] += 3000;
      if (random.chance(0.3)) {
        const [normal] = rotation(random);
        part.mirror = {plane: random.chance(0.7) ? [1, 0, 0, 0] : [...normal, random.between(-50, 50)]};
      }
      if (random.chance(0.1)) part.skeleton = false;
      if (random.chance(0.1)) {
        part.attachment = {part: random.chance(0.2) ? '' : `part-${1 + random.below(count)}`,
          at: [random.between(-90, 90), random.between(-90, 90)]};
      }
    }
    if (random.chance(0.1)) part.root = true;
    if (random.chance(0.2)) {
      part.refine = {simplify: random.between(0, 40), merge: random.between(0, 90),
        prune: random.between(0, 90), collapse: random.between(0, 40), branches: {b0: 3}};
    }
    parts.push(part);
  }
  const refine = random.chance(0.5) ? {} : {simplify: random.between(0, 30),
    merge: random.between(0, 80), prune: random.between(0, 80), collapse: random.between(0, 60)};
  return {format: 'marrow', version: 1, parts, refine};
}

function rigBy([command, ...words], document, options) {
  const [json, obj] = ['rig.json', 'rig.obj'].map((name) => path.join(folder, name));
  for (const file of [json, obj]) fs.rmSync(file, {force: true});
  const done = spawnSync(command, [...words, 'rig', document, '--json', json, '--obj', obj,
    ...options], {encoding: 'utf8'});
  assert.equal(done.status, 0, `${command}: ${done.stderr}`);
  const rig = JSON.parse(fs.readFileSync(json, 'utf8'));
  delete rig.timings;
  return {rig, obj: fs.readFileSync(obj, 'utf8')};
}

function compare(document, options) {
  const [a, b] = [programs.native, programs.wasm].map((program) => rigBy(program, document, options));
  for (const field of Object.keys(a.rig)) assert.deepEqual(b.rig[field], a.rig[field], field);
  assert.ok(a.obj === b.obj, 'the meshes differ');
  return a.rig;
}

const documents = [];
for (let seed = 1; seed <= 24; ++seed) {
  const file = path.join(folder, `creature ${seed}.json`);
  fs.writeFileSync(file, JSON.stringify(creature(seed)));
  documents.push(file);
}
if (fs.existsSync(samples)) {
  documents.push(...fs.readdirSync(samples).filter((name) => name.endsWith('.json')).sort()
      .map((name) => path.join(samples, name))
      .filter((file) => JSON.parse(fs.readFileSync(file, 'utf8')).format === 'marrow'));
}

let failed = 0, connections = 0;
for (const [i, document] of documents.entries()) {
  const name = path.basename(document, '.json');
  try {
    const rig = compare(document, i % 4 === 3 ? ['--eps-s', '1', '--eps-m', '60'] : []);
    connections += rig.connections.length;
    console.log(`ok      ${name}: ${rig.joints.length} joints, ${rig.connections.length} connections`);
  } catch (error) {
    ++failed;
    console.log(`FAILED  ${name}: ${error.message.split('\n').slice(0, 12).join('\n')}`);
  }
}
assert.ok(connections > documents.length, 'the creatures hang together');
fs.rmSync(folder, {recursive: true});
console.log(`${documents.length - failed} passed, ${failed} failed`);
process.exitCode = failed ? 1 : 0;
