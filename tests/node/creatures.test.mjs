// node creatures.test.mjs NATIVE WASM.js CREATURES: random creatures become
// one sound body with weights each, of all parts that are shown, in a GLB without a fault for
// Khronos' validator. WebAssembly makes the same file of every tenth. COUNT in the environment: how
// many, a few without; FIRST: the number of the first.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import {createRequire} from 'node:module';
import os from 'node:os';
import path from 'node:path';
import {fileURLToPath} from 'node:url';

const validator = createRequire(import.meta.url)('gltf-validator');
const [native, wasm, creatures] = process.argv.slice(2);
const {COUNT: count = '12', FIRST: first = '1'} = process.env;
const here = path.dirname(fileURLToPath(import.meta.url));
const programs = {native: [native], wasm: [process.execPath, path.join(here, 'run.cjs'), wasm]};
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'marrow-creatures-'));

function run(program, ...words) {
  const [command, ...before] = program;
  const done = spawnSync(command, [...before, ...words], {encoding: 'utf8', maxBuffer: 1 << 28});
  assert.equal(done.stderr, '', words.join(' '));
  assert.equal(done.status, 0, words.join(' '));
}

/// What `marrow rig` makes of a document: its GLB and its report.
function rig(target, file) {
  const [glb, json] = ['glb', 'rig.json'].map((end) => file.replace('json', `${target}.${end}`));
  run(programs[target], 'rig', file, '--glb', glb, '--json', json);
  return {glb: fs.readFileSync(glb), tree: JSON.parse(fs.readFileSync(json, 'utf8'))};
}

/// The tree in a GLB.
function treeOf(glb) {
  return JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)).toString());
}

async function check(file) {
  const document = JSON.parse(fs.readFileSync(file, 'utf8'));
  const {glb, tree} = rig('native', file);
  const {merged, weights, leftOut} = tree;
  assert.deepEqual(leftOut ?? [], [], 'parts are left out');
  const shown = document.parts.filter(({visible}) => visible !== false);
  if (!shown.length) return 'nothing to see';
  assert.ok(merged.closed && merged.manifold, 'the body is no solid');
  assert.equal(merged.selfIntersections, 0, 'the body crosses itself');
  assert.ok(merged.volume > 0);
  assert.equal(weights.bones, tree.bones.length);
  assert.ok(weights.maxSumError < 1e-9 && weights.min >= 0 && weights.max <= 1, 'weights');
  const {issues} = await validator.validateBytes(new Uint8Array(glb));
  assert.deepEqual(issues.messages.filter(({severity}) => severity < 2), [], 'the validator');
  const skinned = treeOf(glb).meshes.every(({primitives}) =>
      primitives.every(({attributes}) => 'JOINTS_0' in attributes && 'WEIGHTS_0' in attributes));
  assert.ok(skinned || !tree.bones.length, 'a mesh follows no bone');
  return `${shown.length} parts, ${tree.bones.length} bones, ${merged.vertices} vertices`;
}

run([creatures], folder, first, count);
let failed = 0;
for (let i = 0; i < Number(count); ++i) {
  const number = Number(first) + i;
  const file = path.join(folder, `${number}.json`);
  try {
    const what = await check(file);
    if (i % 10 === 0) assert.ok(rig('wasm', file).glb.equals(rig('native', file).glb), 'wasm');
    console.log(`ok      ${number}: ${what}`);
  } catch (error) {
    ++failed;
    console.log(`FAILED  ${number}: ${error.message}`);
  }
  for (const name of fs.readdirSync(folder)) {
    if (name.startsWith(`${number}.`)) fs.unlinkSync(path.join(folder, name));
  }
}
fs.rmSync(folder, {recursive: true});
console.log(`${count - failed} passed, ${failed} failed`);
process.exitCode = failed ? 1 : 0;
