// node files.test.mjs BUILD_FOLDER: the desktop app opens and saves files, keeps drawings by itself
// and finds them again when it was killed.
import assert from 'node:assert/strict';
import {spawn, spawnSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';

const program = path.join(process.argv[2], 'marrow-app');
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'marrow-files-'));
const at = (name) => path.join(folder, name);
const env = {...process.env, XDG_DATA_HOME: at('data')};
const kept = () => {
  const where = at('data/marrow');
  if (!fs.existsSync(where)) return [];
  return fs.readdirSync(where).filter((name) => name.endsWith('.json'))
      .map((name) => JSON.parse(fs.readFileSync(path.join(where, name), 'utf8')));
};
const write = (name, value) => {
  fs.writeFileSync(at(name), typeof value === 'string' ? value : JSON.stringify(value));
  return at(name);
};
const run = (...options) => spawnSync(program, options, {encoding: 'utf8', env, timeout: 60_000});
const sleep = (ms) => new Promise((done) => setTimeout(done, ms));
async function until(what, is) {
  for (let i = 0; i < 200; ++i) {
    if (is()) return;
    await sleep(100);
  }
  assert.fail(`waited in vain: ${what}`);
}

const ring = Array.from({length: 60}, (_, i) => [120 * Math.cos(i / 60 * 2 * Math.PI),
                                                120 * Math.sin(i / 60 * 2 * Math.PI)]);
const stroke = write('stroke.json', {name: 'ring', closed: true, points: ring.map(
    (p) => p.map(Math.round))});
const drawing = {format: 'marrow', version: 1, mine: [1], parts: [{stroke: {points: ring}}]};

const tests = {
  'a drawing is opened and written as it was'() {
    const file = write('ring.json', drawing), out = at('out.json');
    const done = run(file, '--save', out);
    assert.equal(done.status, 0, done.stderr);
    const text = JSON.parse(fs.readFileSync(out, 'utf8'));
    assert.deepEqual(text.parts[0].stroke.points, ring);
    assert.deepEqual(text.mine, [1]);
    assert.equal(text.title, 'ring');
    const again = at('again.json');
    assert.equal(run(out, '--save', again).status, 0);
    assert.equal(fs.readFileSync(again, 'utf8'),
                 fs.readFileSync(out, 'utf8').replace('"title":"ring"', '"title":"out"'));
  },
  'a 3D model is imported'() {
    const file = write('tetra.obj', 'v 0 0 0\nv 9 0 0\nv 0 9 0\nv 2 2 7\n' +
        'f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n');
    const out = at('tetra.json');
    const done = run(file, '--save', out);
    assert.equal(done.status, 0, done.stderr);
    const [part] = JSON.parse(fs.readFileSync(out, 'utf8')).parts;
    assert.equal(part.name, 'tetra');
    assert.equal(Buffer.from(part.mesh.triangles, 'base64').length, 48);
  },
  'what cannot be opened is said in one line'() {
    for (const [name, text] of Object.entries({
      'empty.json': '', 'half.json': '{"format": "marrow"', 'newer.json':
          JSON.stringify({...drawing, version: 2}), 'photo.png': '\x89PNG but no picture'})) {
      const done = run(write(name, text), '--save', at('never.json'));
      assert.equal(done.status, 2, name);
      assert.match(done.stderr, /^marrow-app: [^\n]+\.\n$/, name);
    }
    const missing = run(at('missing.json'), '--save', at('never.json'));
    assert.equal(missing.status, 2);
    assert.match(missing.stderr, /missing\.json cannot be read/);
    assert.ok(!fs.existsSync(at('never.json')));
  },
  async 'what was drawn is found again when the app was killed'() {
    const app = spawn(program, ['--play', stroke], {env, stdio: 'ignore', detached: true});
    await until('the drawing is kept', () => kept().length === 1);
    assert.equal(kept()[0].parts.length, 1);
    // As long as it lives, nobody else takes it.
    const other = run('--restore', '--save', at('other.json'));
    assert.equal(other.status, 2, 'it is open elsewhere');
    process.kill(-app.pid, 'SIGKILL');
    await sleep(300);
    const found = run('--restore', '--save', at('found.json'));
    assert.equal(found.status, 0, found.stderr);
    assert.deepEqual(JSON.parse(fs.readFileSync(at('found.json'), 'utf8')).parts, kept()[0].parts);
  },
};

let failed = 0;
for (const [name, check] of Object.entries(tests)) {
  try {
    await check();
    console.log(`ok      ${name}`);
  } catch (error) {
    ++failed;
    console.log(`FAILED  ${name}: ${error.stack.split('\n').slice(0, 12).join('\n')}`);
  }
}
fs.rmSync(folder, {recursive: true, force: true});
process.exitCode = failed ? 1 : 0;
