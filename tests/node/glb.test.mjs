// node glb.test.mjs NATIVE WASM.js: the GLB of every sample has no fault for Khronos' validator;
// three.js finds the rig's joints in it, each below its parent, and moves the body as we do.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {fileURLToPath} from 'node:url';

import {checkJoints, heightOf, load, validate, worstVertex} from './gltf.mjs';

const [native, wasm] = process.argv.slice(2);
const here = path.dirname(fileURLToPath(import.meta.url));
const programs = {native: [native], wasm: [process.execPath, path.join(here, 'run.cjs'), wasm]};
const samples = path.resolve(here, '../../public/samples');
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'marrow-glb-'));
for (const target of Object.keys(programs)) fs.mkdirSync(path.join(folder, target));
const kMetresPerUnit = 0.01;

function run(target, ...words) {
  const [program, ...first] = programs[target];
  const done = spawnSync(program, [...first, ...words], {encoding: 'utf8', maxBuffer: 1 << 28});
  assert.equal(done.stderr, '', `${target} ${words.join(' ')}`);
  assert.equal(done.status, 0);
}

/// What `marrow rig` gives of a document.
function rig(target, document, name, ...options) {
  const [file, glb, json] = ['json', 'glb', 'rig.json'].map((end) =>
      path.join(folder, target, `${name}.${end}`));
  fs.writeFileSync(file, JSON.stringify(document));
  run(target, 'rig', file, '--glb', glb, '--json', json, ...options);
  return {file, glb: fs.readFileSync(glb), tree: JSON.parse(fs.readFileSync(json, 'utf8'))};
}

/// A rotation of every joint, small numbers that look random, and a jump of the roots.
function wave(tree) {
  const joints = {};
  tree.joints.forEach(({id, parent}, i) => {
    const turn = (k) => ((i * 7 + k * 5) % 11 - 5) / 30;
    joints[id] = {rotation: [turn(1), turn(2), turn(3), 1], ...(parent ? {} : {move: [5, 20, -8]})};
  });
  return joints;
}

/// Vertices and the triangles' corners, of an OBJ file of ours.
function readObj(file) {
  const vertices = [], corners = new Map();  // group → vertex numbers
  let group;
  for (const line of fs.readFileSync(file, 'utf8').split('\n')) {
    const [word, ...rest] = line.split(' ');
    if (word === 'v') vertices.push(rest.map(Number));
    if (word === 'g') corners.set(rest[0], group = []);
    if (word === 'f') for (const corner of rest) group.push(parseInt(corner, 10) - 1);
  }
  return {vertices, groups: [...corners.values()]};
}

function checkReport(name, {merged, weights}) {
  assert.ok(merged.closed && merged.manifold && merged.selfIntersections === 0, name);
  assert.ok(merged.volume > 0 && merged.triangles > 100, name);
  assert.ok(weights.maxSumError < 1e-9 && weights.min >= 0 && weights.max <= 1, name);
}

const files = fs.readdirSync(samples).filter((file) => file.endsWith('.json'));
assert.ok(files.length >= 8);
for (const file of files) {
  const name = file.replace('.json', '');
  const document = JSON.parse(fs.readFileSync(path.join(samples, file), 'utf8'));
  const plain = rig('native', document, `${name}-rest`, '--no-weights');
  await validate(name, plain.glb);
  assert.ok(!(await load(plain.glb)).meshes[0].isSkinnedMesh);

  document.poses = [{name: 'Wave', joints: wave(plain.tree)}];
  const posed = rig('native', document, name);
  await validate(name, posed.glb);
  checkReport(name, posed.tree);
  const loaded = await load(posed.glb);
  checkJoints(loaded, posed.tree, kMetresPerUnit);
  const obj = path.join(folder, `${name}.obj`);
  run('native', 'pose', posed.file, '--pose', 'Wave', '--obj', obj);
  const worst = worstVertex(loaded, 'Wave', readObj(obj), kMetresPerUnit);
  assert.ok(worst < 1e-4, `${name}: a vertex is off by ${worst} of the size`);
  console.log(`ok      ${name}: ${loaded.meshes[0].skeleton.bones.length} joints, a posed vertex is ` +
              `off by ${worst.toExponential(1)} at most`);
}

// As a text it is the same file; soft seams and another scale are as valid.
{
  const snail = JSON.parse(fs.readFileSync(path.join(samples, 'snail.json'), 'utf8'));
  snail.blend = 15;
  const text = path.join(folder, 'snail.gltf');
  const soft = rig('native', snail, 'soft', '--gltf', text, '--scale', '0.5');
  await validate('soft', soft.glb);
  await validate('snail.gltf', fs.readFileSync(text));
  checkReport('soft', soft.tree);
  const overruled = rig('native', snail, 'hard', '--blend', '0', '--scale=0.5');
  assert.ok(soft.tree.merged.volume > overruled.tree.merged.volume);
  const bytes = JSON.parse(fs.readFileSync(text, 'utf8')).buffers[0].uri.split(',')[1];
  const binary = soft.glb.subarray(soft.glb.indexOf('BIN\0') + 4);
  const own = Buffer.from(bytes, 'base64');
  assert.ok(own.length > 1000 && binary.subarray(0, own.length).equals(own));
  const height = async (glb) => heightOf(await load(glb));
  const plain = rig('native', {...snail, blend: 0}, 'plain');
  const times = await height(overruled.glb) / await height(plain.glb);
  assert.ok(Math.abs(times - 50) < 1e-3, `50 times as high: ${times}`);
  console.log('ok      text, soft seams, scale');
}

// Each part by itself, and the same solid from WebAssembly.
const dog = JSON.parse(fs.readFileSync(path.join(samples, 'dog.json'), 'utf8'));
const parts = rig('native', dog, 'parts', '--parts');
await validate('parts', parts.glb);
const shown = (await load(parts.glb)).meshes;
assert.equal(shown.length, dog.parts.length + dog.parts.filter(({mirror}) => mirror).length);
assert.ok(shown.every((mesh) => mesh.isSkinnedMesh));
const twice = ['native', 'wasm'].map((target) => rig(target, dog, 'dog'));
await validate('wasm', twice[1].glb);
assert.ok(twice[0].glb.equals(twice[1].glb), 'native and wasm write other bytes');
console.log('ok      parts, and the same bytes from WebAssembly');
fs.rmSync(folder, {recursive: true});
