// node run.mjs FOLDER [SECONDS]: runs the fuzzers that are in FOLDER, from the documents in
// tests/data and small meshes. A fixed number of runs with a fixed seed, or for SECONDS each; what breaks one is
// kept in FOLDER/artifacts, where SECONDS are given what was found as well, in FOLDER/corpus. Exit
// code 77, which skips the test, where they are not built.
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import {fileURLToPath} from 'node:url';

const kRuns = {document: 8000, command: 300, obj: 8000, stl: 8000, ply: 8000, glb: 8000};
// Bytes.
const kLongest = {document: 4096, command: 800, obj: 2000, stl: 2000, ply: 2000, glb: 4096};
const kSkipped = 77;

const [folder, seconds] = process.argv.slice(2);
const data = path.join(path.dirname(fileURLToPath(import.meta.url)), '..', 'data', 'documents');
const missing = Object.keys(kRuns).filter(
    (name) => !fs.existsSync(path.join(folder, `${name}_fuzzer`)));
if (missing.length > 0) {
  console.log(`fuzz: not built: ${missing.join(', ')}`);
  process.exit(process.env.CI ? 1 : kSkipped);
}

// A tetrahedron, as every format has it.
const points = [[0, 0, 0], [100, 0, 0], [0, 80, 0], [20, 20, 60]];
const triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
const lines = (start, list) => list.map((one) => start + one.join(' ') + '\n').join('');
const floats = Buffer.from(Float32Array.from(points.flat()).buffer);
const bytes32 = (...values) => Buffer.from(Uint32Array.from(values).buffer);
const plyHeader = (format) =>
    `ply\nformat ${format} 1.0\ncomment\nelement vertex 4\nproperty float x\nproperty float y\n` +
    'property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n';
function glb(json, binary) {
  const text = Buffer.from(JSON.stringify(json).padEnd(1200));
  return Buffer.concat([
    Buffer.from('glTF'), bytes32(2, 28 + text.length + binary.length),
    bytes32(text.length, 0x4E4F534A), text, bytes32(binary.length, 0x004E4942), binary]);
}
const kMeshes = {
  obj: [lines('v ', points) + lines('f ', triangles.map((t) => t.map((i) => i + 1))),
        lines('v ', points) + 'o a\nf -4//1 2/1/1 3 -1\nf 1 2 3 \\\n 4\n'],
  stl: ['solid a\n' + triangles.map((t) => 'facet normal 0 0 1\nouter loop\n' +
            lines('vertex ', t.map((i) => points[i])) + 'endloop\nendfacet\n').join('') +
            'endsolid a\n',
        Buffer.concat([Buffer.alloc(80), bytes32(4), ...triangles.map((t) => Buffer.concat([
          Buffer.alloc(12), Buffer.from(Float32Array.from(t.flatMap((i) => points[i])).buffer),
          Buffer.alloc(2)]))])],
  ply: [plyHeader('ascii') + lines('', points) + lines('3 ', triangles),
        Buffer.concat([Buffer.from(plyHeader('binary_little_endian')), floats,
                       ...triangles.map((t) => Buffer.concat([Buffer.from([3]), bytes32(...t)]))])],
  glb: [glb({
    asset: {version: '2.0', extras: {marrow: {version: 1, document: 0}}}, scene: 0,
    scenes: [{nodes: [0]}],
    nodes: [{children: [1], rotation: [0, 0, 1, 1]},
            {mesh: 0, translation: [1, 2, 3], scale: [1, 2, -1], skin: 0}],
    skins: [{joints: [0], inverseBindMatrices: 2}],
    meshes: [{primitives: [{mode: 4, attributes: {POSITION: 0}, indices: 1}]}],
    buffers: [{byteLength: 160}],
    bufferViews: [{buffer: 0, byteLength: 48}, {buffer: 0, byteOffset: 48, byteLength: 48},
                  {buffer: 0, byteOffset: 96, byteLength: 64}],
    accessors: [{bufferView: 0, type: 'VEC3', componentType: 5126, count: 4},
                {bufferView: 1, type: 'SCALAR', componentType: 5125, count: 12},
                {bufferView: 2, type: 'MAT4', componentType: 5126, count: 1}],
  }, Buffer.concat([floats, bytes32(...triangles.flat()), Buffer.from(Float32Array.from(
      [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]).buffer)]))],
};

const artifacts = path.join(folder, 'artifacts');
fs.mkdirSync(artifacts, {recursive: true});
for (const name of Object.keys(kRuns)) {
  const seeds = path.join(folder, 'seeds', name);
  fs.rmSync(seeds, {recursive: true, force: true});
  fs.mkdirSync(seeds, {recursive: true});
  if (name === 'document') {
    for (const list of ['good', 'bad']) {
      const documents = JSON.parse(fs.readFileSync(path.join(data, `${list}.json`), 'utf8'));
      for (const [title, document] of Object.entries(documents)) {
        fs.writeFileSync(path.join(seeds, `${list}-${title}`), JSON.stringify(document));
      }
    }
  } else if (kMeshes[name]) {
    kMeshes[name].forEach((mesh, i) => fs.writeFileSync(path.join(seeds, `${i}`), mesh));
  } else {
    for (let i = 0; i < 16; ++i) {
      const bytes = Array.from({length: 400}, (_, k) => (k * (2 * i + 1) + (k >> 3) * 7 + i) % 256);
      fs.writeFileSync(path.join(seeds, `${i}`), Buffer.from(bytes));
    }
  }
  const corpus = path.join(folder, 'corpus', name);
  if (seconds) fs.mkdirSync(corpus, {recursive: true});
  const options = seconds
      ? [`-max_total_time=${seconds}`, '-print_final_stats=1', corpus]
      : [`-runs=${kRuns[name]}`, '-seed=1'];
  const {status} = spawnSync(path.resolve(folder, `${name}_fuzzer`), [
    `-max_len=${kLongest[name]}`, '-timeout=60', `-artifact_prefix=${artifacts}/${name}-`,
    ...options, seeds], {stdio: 'inherit'});
  if (status !== 0) process.exit(1);
}
