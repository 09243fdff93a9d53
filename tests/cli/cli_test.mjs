// The command line from outside: cli_test.mjs PROGRAM [FOLDER WITH strokes/]
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';

import {rigClaims} from './rig_claims.mjs';

const [, , given, shared] = process.argv;
assert.ok(given && fs.existsSync(given), `no program ${given}: build it first`);
const program = path.resolve(given);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'marrow-cli-'));
const inFolder = (name) => path.join(folder, name);
const run = (...words) => spawnSync(program, words, {cwd: folder, encoding: 'utf8'});

function write(name, content) {
  fs.writeFileSync(inFolder(name), typeof content === 'object' && !Buffer.isBuffer(content)
      ? JSON.stringify(content) : content);
  return name;
}

function wavyRing(count, size = 200) {
  const points = [];
  for (let i = 0; i < count; ++i) {
    const angle = 2 * Math.PI * i / count;
    const radius = size * (1 + 0.3 * Math.sin(5 * angle));
    points.push([radius * Math.cos(angle), radius * Math.sin(angle)]);
  }
  return points;
}

const claims = [];
const claim = (name, check) => claims.push({name, check});
const stroke = {name: 'star', closed: true, points: wavyRing(120)};

function allNumbersFinite(value) {
  if (typeof value === 'number') return Number.isFinite(value);
  if (value === null) return false;
  return typeof value === 'object' ? Object.values(value).every(allNumbersFinite) : true;
}

function checkPart(part, name) {
  assert.deepEqual(Object.keys(part), ['name', 'outline', 'polygon', 'straightSkeleton',
    'skeleton', 'mesh', 'timings']);
  assert.equal(part.name, name);
  assert.ok(allNumbersFinite(part));
  assert.ok(part.outline.length >= 3 && part.outline.every((p) => p.length === 2));
  assert.ok(part.polygon.length >= 3 && part.polygon.every((p) => p.length === 2));
  const {method, nodes, edges} = part.straightSkeleton;
  assert.ok(['wavefront', 'cgal'].includes(method));
  assert.ok(nodes.every((node) => node.length === 3 && node[2] >= 0));
  for (const [i, j, kind] of edges) {
    assert.ok(i < nodes.length && j < nodes.length);
    assert.ok(['border', 'peripheral', 'skeleton'].includes(kind));
  }
  const {joints, bones} = part.skeleton;
  assert.equal(bones.length, joints.length - 1, 'a tree');
  for (const joint of joints) {
    assert.deepEqual(Object.keys(joint), ['kind', 'position', 'radius']);
    assert.ok(['terminal', 'sleeve', 'junction'].includes(joint.kind));
    assert.equal(joint.position.length, 3);
    assert.ok(joint.radius > 0);
  }
  assert.deepEqual(Object.keys(part.mesh),
      ['vertices', 'triangles', 'closed', 'manifold', 'volume']);
  assert.ok(part.mesh.closed && part.mesh.manifold && part.mesh.volume > 0);
  assert.equal(part.mesh.triangles, 2 * part.mesh.vertices - 4, 'a sphere');
  assert.ok('total' in part.timings);
}

claim('a stroke becomes JSON, OBJ and SVG', () => {
  const done = run('part', write('star.json', stroke), '--json', 'o.json', '--obj', 'o.obj',
      '--svg', 'o.svg');
  assert.equal(done.status, 0, done.stderr);
  assert.equal(done.stdout + done.stderr, '');
  const part = JSON.parse(fs.readFileSync(inFolder('o.json'), 'utf8'));
  checkPart(part, 'star');

  const lines = fs.readFileSync(inFolder('o.obj'), 'utf8').split('\n');
  const count = (word) => lines.filter((line) => line.startsWith(word + ' ')).length;
  assert.equal(count('v'), part.mesh.vertices + part.skeleton.joints.length);
  assert.equal(count('vn'), part.mesh.vertices);
  assert.equal(count('f'), part.mesh.triangles);
  assert.equal(count('l'), part.skeleton.bones.length);

  const svg = fs.readFileSync(inFolder('o.svg'), 'utf8');
  assert.ok(svg.startsWith('<svg') && svg.endsWith('</svg>\n') && !svg.includes('nan'));
});

claim('the same stroke gives the same part', () => {
  write('star.json', stroke);
  const texts = ['a', 'b'].map((name) => {
    assert.equal(run('part', 'star.json', '--json', name, '--obj', name + '.obj').status, 0);
    const part = JSON.parse(fs.readFileSync(inFolder(name), 'utf8'));
    delete part.timings;
    return JSON.stringify(part) + fs.readFileSync(inFolder(name + '.obj'), 'utf8');
  });
  assert.equal(texts[0], texts[1]);
});

claim('an open stroke is closed', () => {
  const half = {name: 'half', closed: false, points: wavyRing(120).slice(0, 70)};
  assert.equal(run('part', write('half.json', half), '--json', 'half.out').status, 0);
  checkPart(JSON.parse(fs.readFileSync(inFolder('half.out'), 'utf8')), 'half');
});

claim('whole numbers, large ones too, are coordinates', () => {
  const square = {points: [[0, 0], [123456789012345678901234567890, 0], [5e29, 4e29], [0, 3e29]]};
  assert.equal(run('part', write('big.json', square)).status, 0);
});

claim('without an output a short summary is printed', () => {
  const done = run('part', write('star.json', stroke));
  assert.equal(done.status, 0);
  assert.match(done.stdout, /star: 120 points/);
  assert.match(done.stdout, /joints, \d+ bones/);
  assert.equal(done.stderr, '');
});

claim('options change what they name', () => {
  write('star.json', stroke);
  const volume = (...words) => {
    const done = run('part', 'star.json', '--json', 'v.json', ...words);
    assert.equal(done.status, 0, done.stderr);
    return JSON.parse(fs.readFileSync(inFolder('v.json'), 'utf8')).mesh.volume;
  };
  const one = volume(), two = volume('--thickness=2');
  assert.ok(Math.abs(two / one - 2) < 1e-9);
  assert.equal(volume('--eps-s', '20'), one);
});

claim('help is asked for or deserved', () => {
  for (const words of [['--help'], ['part', '--help'], ['rig', '--help'], ['-h']]) {
    const done = run(...words);
    assert.equal(done.status, 0);
    assert.match(done.stdout, /^Usage: marrow part STROKE.json/);
    assert.match(done.stdout, /marrow rig DOCUMENT.json/);
    assert.equal(done.stderr, '');
  }
  const bare = run();
  assert.equal(bare.status, 2);
  assert.match(bare.stderr, /^Usage/);
  assert.equal(bare.stdout, '');
});

/// Exit code 2, one line that names the file and says more than that, no output touched.
function checkRefused(words, naming) {
  const before = fs.readdirSync(folder);
  write('kept.json', 'old');
  const done = run(...words, '--json', 'kept.json', '--obj', 'fresh.obj', '--svg', 'fresh.svg');
  assert.equal(done.status, 2, `${words}: status ${done.status}, signal ${done.signal}`);
  assert.equal(done.stdout, '');
  assert.match(done.stderr, /^marrow: [^\n]{10,300}\n$/, `${words}: ${done.stderr}`);
  assert.ok(done.stderr.includes(naming), `${words}: ${done.stderr}`);
  assert.equal(fs.readFileSync(inFolder('kept.json'), 'utf8'), 'old');
  fs.rmSync(inFolder('kept.json'));
  assert.deepEqual(fs.readdirSync(folder), before.filter((name) => name !== 'kept.json'));
}

const triangle = '[[0,0],[9,0],[0,9]]';
const badStrokes = {
  'empty': '',
  'only white space': ' \n\t',
  'not JSON': 'hello',
  'cut off': JSON.stringify(stroke).slice(0, -9),
  'trailing text': `{"points":${triangle}} x`,
  'a comment': `{"points":${triangle} /* three */}`,
  'UTF-16': Buffer.from(`{"points":${triangle}}`, 'utf16le'),
  'broken UTF-8': Buffer.from([0x7b, 0x22, 0xff, 0xfe, 0x22, 0x3a, 0x31, 0x7d]),
  'zero bytes': Buffer.alloc(1000),
  'a million brackets': '['.repeat(1e6),
  'a million objects': '{"a":'.repeat(1e6),
  'deep inside': `{"points":${triangle},"x":${'['.repeat(1e5)}${']'.repeat(1e5)}}`,
  'a number': '5',
  'null': 'null',
  'a list': triangle,
  'no points': '{"name":"x","closed":true}',
  'points null': '{"points":null}',
  'points an object': '{"points":{"0":[0,0]}}',
  'points a text': '{"points":"0,0 9,0 0,9"}',
  'no point': '{"points":[]}',
  'one point': '{"points":[[1,2]]}',
  'two points': '{"points":[[1,2],[3,4]]}',
  'two distinct points': '{"points":[[1,2],[3,4],[1,2],[3,4],[3,4]]}',
  'no area': '{"points":[[0,0],[1,1],[2,2],[5,5]]}',
  'there and back': '{"points":[[0,0],[7,1],[9,5],[7,1],[0,0]]}',
  'overflow': '{"points":[[0,0],[1e999,0],[0,9]]}',
  'negative overflow': '{"points":[[0,0],[-1e999,0],[0,9]]}',
  'NaN': '{"points":[[0,0],[NaN,0],[0,9]]}',
  'Infinity': '{"points":[[0,0],[Infinity,0],[0,9]]}',
  'null coordinate': '{"points":[[0,0],[null,0],[0,9]]}',
  'text coordinate': '{"points":[[0,0],["9",0],[0,9]]}',
  'boolean coordinate': '{"points":[[0,0],[true,0],[0,9]]}',
  'three coordinates': '{"points":[[0,0,1],[9,0,1],[0,9,1]]}',
  'one coordinate': '{"points":[[0],[9],[0]]}',
  'flat list': '{"points":[0,0,9,0,0,9]}',
  'points as objects': '{"points":[{"x":0,"y":0},{"x":9,"y":0},{"x":0,"y":9}]}',
  'farther than any drawing': '{"points":[[0,0],[1e300,0],[0,1e300]]}',
  'name a number': `{"name":5,"points":${triangle}}`,
  'closed a text': `{"closed":"yes","points":${triangle}}`,
};
for (const [name, content] of Object.entries(badStrokes)) {
  claim(`refuses a stroke: ${name}`, () => {
    checkRefused(['part', write('bad stroke.json', content)], 'bad stroke.json: ');
  });
}

claim('says which point is wrong', () => {
  const points = wavyRing(20).map(String).map(() => [0, 1]);
  points[17] = [0, 'x'];
  const done = run('part', write('bad.json', {points}));
  assert.equal(done.stderr, 'marrow: bad.json: points[17] is not a pair of numbers.\n');
});

claim('refuses files that are not there, not readable or not files', () => {
  checkRefused(['part', 'nowhere.json'], 'nowhere.json: There is no such file.');
  checkRefused(['part', '.'], '.: It is a directory.');
  checkRefused(['part', ''], '');
  checkRefused(['part', '/dev/null'], '/dev/null: It is empty.');
  checkRefused(['part', '/dev/zero'], '/dev/zero: ');
  checkRefused(['part', 'two\nlines.json'], 'two?lines.json: ');
  if (process.getuid?.() !== 0) {
    fs.chmodSync(inFolder(write('closed.json', stroke)), 0);
    checkRefused(['part', 'closed.json'], 'closed.json: It cannot be read.');
  }
});

claim('refuses words it does not know', () => {
  write('star.json', stroke);
  const bad = [
    ['whole'], ['part'], ['part', 'star.json', '--eps', '5'], ['part', 'star.json', 'star.json'],
    ['part', '--', '--help'], ['part', 'star.json', '--obj'], ['part', 'star.json', '--obj='],
    ['part', 'star.json', '--eps-s', '--thickness', '1'], ['--part', 'star.json'], [''],
  ];
  for (const words of bad) checkRefused(words, '');
  for (const option of ['--eps-s', '--thickness']) {
    for (const value of ['abc', '', ' ', 'nan', 'inf', '-inf', '-1', '0', '1e999', '5x', '0x10',
      '1,5', '--', '1e-300', '1e300', '5 5', '--eps-s']) {
      checkRefused(['part', 'star.json', option, value], '');
    }
  }
});

claim('touches no output when one of them cannot be written', () => {
  write('star.json', stroke);
  for (const place of ['no/such/folder.obj', '.', folder, 'star.json/x.obj', 'star.json']) {
    write('kept.json', 'old');
    const before = fs.readdirSync(folder);
    const done = run('part', 'star.json', '--json', 'kept.json', '--obj', place, '--svg', 'f.svg');
    assert.equal(done.status, 2, place);
    assert.match(done.stderr, /^marrow: [^\n]+\n$/);
    assert.ok(done.stderr.includes(place));
    assert.equal(fs.readFileSync(inFolder('kept.json'), 'utf8'), 'old');
    assert.deepEqual(fs.readdirSync(folder), before);
  }
  assert.equal(run('part', 'star.json', '--obj', 'same', '--svg', './same').status, 2);
  assert.ok(!fs.existsSync(inFolder('same')));
});

claim('an output may be a device or a link, and stays one', () => {
  write('star.json', stroke);
  // Through a real pipe: the standard output that Node gives may be a socket, which has no path.
  const done = spawnSync('sh', ['-c',
    '"$0" part star.json --svg /dev/null --obj /dev/stdout | cat', program],
  {cwd: folder, encoding: 'utf8'});
  assert.match(done.stdout, /^# Marrow/, done.stderr);
  assert.ok(!fs.statSync('/dev/null').isFile());
  write('real.svg', 'old');
  fs.symlinkSync('real.svg', inFolder('link.svg'));
  assert.equal(run('part', 'star.json', '--svg', 'link.svg').status, 0);
  assert.ok(fs.lstatSync(inFolder('link.svg')).isSymbolicLink());
  assert.match(fs.readFileSync(inFolder('real.svg'), 'utf8'), /^<svg/);
});

claim('100,000 samples are a stroke like any other', () => {
  const points = wavyRing(100000).map(([x, y], i) => [x + 0.3 * (i * 7919 % 13), y]);
  const done = run('part', write('long.json', {points}), '--json', 'long.out');
  assert.equal(done.status, 0, done.stderr);
  checkPart(JSON.parse(fs.readFileSync(inFolder('long.out'), 'utf8')), '');
});

claim('every real stroke becomes a sound part', () => {
  const strokes = shared ? path.join(shared, 'strokes') : '';
  if (!strokes || !fs.existsSync(strokes)) {
    console.log('  skipped: no folder of real strokes');
    return;
  }
  for (const file of fs.readdirSync(strokes)) {
    const done = run('part', path.join(strokes, file), '--json', 'real.json');
    assert.equal(done.status, 0, `${file}: ${done.stderr}`);
    const part = JSON.parse(fs.readFileSync(inFolder('real.json'), 'utf8'));
    checkPart(part, part.name);
  }
});

claim('any broken copy of a stroke is a part or a refusal', () => {
  const whole = Buffer.from(JSON.stringify({name: 'x', closed: true, points: wavyRing(12)}));
  let seed = 12345;
  const random = (below) => {
    seed = (Math.imul(seed, 1103515245) + 12345) >>> 0;
    return Math.floor(seed / 2 ** 32 * below);
  };
  for (let i = 0; i < 300; ++i) {
    const bytes = Buffer.from(whole);
    for (let k = random(3); k >= 0; --k) bytes[random(bytes.length)] ^= 1 << random(8);
    const done = run('part', write('mutant.json', i % 5 === 0
        ? bytes.subarray(0, random(bytes.length)) : bytes));
    assert.ok(done.status === 0 || done.status === 2, `${i}: ${done.status} ${done.signal}`);
    if (done.status === 2) assert.match(done.stderr, /^marrow: mutant.json: [^\n]+\n$/);
  }
});

rigClaims({claim, run, write, inFolder, checkRefused});

let failures = 0;
for (const {name, check} of claims) {
  try {
    check();
  } catch (error) {
    ++failures;
    console.log(`not so: ${name}\n  ${String(error.message).replaceAll('\n', '\n  ')}`);
  }
}
fs.rmSync(folder, {recursive: true});
console.log(`${claims.length - failures} of ${claims.length} claims hold`);
process.exit(failures === 0 ? 0 : 1);
