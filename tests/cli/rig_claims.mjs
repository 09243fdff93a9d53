// What is claimed of `marrow rig`; cli_test.mjs checks it.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {fileURLToPath} from 'node:url';

const samples = path.resolve(path.dirname(fileURLToPath(import.meta.url)),
    '../../public/samples');

function ellipse(rx, ry, count = 80) {
  return Array.from({length: count}, (_, i) => {
    const angle = 2 * Math.PI * i / count;
    return [rx * Math.cos(angle), ry * Math.sin(angle)];
  });
}

/// Downwards from the origin, round ends.
function limb(width, length) {
  const cap = (y, from) => Array.from({length: 9}, (_, i) => {
    const angle = from + Math.PI * i / 9;
    return [width / 2 * Math.cos(angle), y + width / 2 * Math.sin(angle)];
  });
  const side = (x, from, to) =>
    Array.from({length: 20}, (_, i) => [x, from + (to - from) * i / 20]);
  return [...side(-width / 2, 0, -length), ...cap(-length, Math.PI),
    ...side(width / 2, -length, 0), ...cap(0, 0)];
}

const at = (origin, x = [1, 0, 0], y = [0, 1, 0]) => ({origin, x, y});
const part = (id, name, points, more = {}) => ({id, name, stroke: {points}, ...more});
const mirror = {plane: [0, 0, 1, 0]};

/// A body with four legs, a head, a tail and ears without bones; a ball beside it.
function creature() {
  return {format: 'marrow', version: 1, parts: [
    part('part-1', 'Body', ellipse(170, 75)),
    part('part-2', 'Front leg', limb(45, 150), {frame: at([110, -30, 45]), mirror}),
    part('part-3', 'Hind leg', limb(50, 150), {frame: at([-110, -30, 45]), mirror}),
    part('part-4', 'Head', ellipse(70, 50), {frame: at([200, 70, 0], [.96, .28, 0], [-.28, .96, 0])}),
    part('part-5', 'Tail', limb(22, 140), {frame: at([-150, 10, 0], [0, -1, 0], [1, 0, 0])}),
    part('part-6', 'Ear', ellipse(12, 35), {frame: at([205, 120, 25]), mirror, skeleton: false}),
    part('part-7', 'Ball', ellipse(40, 40), {frame: at([400, -150, 0])}),
  ]};
}

function allNumbersFinite(value) {
  if (typeof value === 'number') return Number.isFinite(value);
  return value && typeof value === 'object' ? Object.values(value).every(allNumbersFinite) : true;
}

/// What holds of every rig.
function checkRig(rig) {
  assert.deepEqual(Object.keys(rig), ['joints', 'bones', 'connections', 'roots', 'carried',
    'unattached', 'errors', 'timings']);
  assert.ok(allNumbersFinite(rig));
  const places = new Map(rig.joints.map((joint, i) => [joint.id, i]));
  assert.equal(places.size, rig.joints.length, 'ids are unique');
  assert.equal(new Set(rig.joints.map((joint) => joint.name)).size, rig.joints.length, 'names');
  const degrees = rig.joints.map(() => 0);
  rig.joints.forEach((joint, i) => {
    assert.deepEqual(Object.keys(joint),
        ['id', 'name', 'part', 'parent', 'position', 'radius', 'kind']);
    assert.ok(joint.parent === null || places.get(joint.parent) < i, 'parents come first');
    assert.equal(joint.position.length, 3);
    assert.ok(joint.radius > 0);
    if (joint.parent !== null) {
      ++degrees[i];
      ++degrees[places.get(joint.parent)];
    }
  });
  rig.joints.forEach((joint, i) => assert.equal(joint.kind,
      degrees[i] <= 1 ? 'terminal' : degrees[i] === 2 ? 'sleeve' : 'junction', joint.id));
  assert.deepEqual(rig.roots,
      rig.joints.filter((joint) => joint.parent === null).map((joint) => joint.id));
  assert.deepEqual(new Set(rig.bones.map(String)), new Set(rig.joints
      .filter((joint) => joint.parent !== null).map((joint) => `${joint.parent},${joint.id}`)));
  assert.equal(rig.bones.length, rig.joints.length - rig.roots.length, 'a forest');
  for (const connection of rig.connections) {
    assert.deepEqual(Object.keys(connection), ['child', 'parent', 'event', 'test']);
    assert.ok(['split', 'connect'].includes(connection.event));
    assert.ok(['joint', 'overlap', 'user'].includes(connection.test));
    assert.notEqual(connection.child, connection.parent);
  }
  for (const {joint} of rig.carried) assert.ok(joint === null || places.has(joint));
  assert.ok(rig.unattached.length <= Math.max(0, rig.roots.length - 1));
  assert.deepEqual(Object.keys(rig.timings).slice(-2), ['subSkeletons', 'total']);
}

export function rigClaims({claim, run, write, inFolder, checkRefused}) {
  const read = (name) => fs.readFileSync(inFolder(name), 'utf8');
  const rigOf = (document, ...options) => {
    const file = typeof document === 'string' ? document : write('creature.json', document);
    const done = run('rig', file, '--json', 'rig.json', ...options);
    assert.equal(done.status, 0, done.stderr);
    assert.equal(done.stdout + done.stderr, '');
    const rig = JSON.parse(read('rig.json'));
    checkRig(rig);
    return rig;
  };
  const untimed = (rig) => ({...rig, timings: {}});

  claim('a document becomes one rig', () => {
    const rig = rigOf(creature());
    const hangs = Object.fromEntries(rig.connections.map(({child, parent}) => [child, parent]));
    assert.deepEqual(hangs, Object.fromEntries(['part-2', 'part-2:twin', 'part-3', 'part-3:twin',
      'part-4', 'part-5'].map((child) => [child, 'part-1'])));
    assert.deepEqual(new Set(rig.joints.map((joint) => joint.part)), new Set(['part-1', 'part-2',
      'part-2:twin', 'part-3', 'part-3:twin', 'part-4', 'part-5', 'part-7']));
    const partOf = (id) => rig.joints.find((joint) => joint.id === id).part;
    assert.deepEqual(rig.roots.map(partOf), ['part-1', 'part-7']);
    assert.deepEqual(rig.unattached, ['part-7']);
    assert.deepEqual(rig.carried.map((one) => [one.part, partOf(one.joint)]),
        [['part-6', 'part-4'], ['part-6:twin', 'part-4']]);
    assert.deepEqual(rig.errors, []);
    for (const stage of ['outline', 'straightSkeleton', 'axis', 'joints', 'connection',
      'refinement', 'subSkeletons', 'total']) {
      assert.ok(rig.timings[stage] > 0, stage);
    }
    const {outline, straightSkeleton, axis, joints, subSkeletons, total} = rig.timings;
    assert.ok(Math.abs(outline + straightSkeleton + axis + joints - subSkeletons) < 1e-9);
    assert.ok(subSkeletons < total);
  });

  claim("twins' joints are mirror images, with sides in their names", () => {
    const {joints} = rigOf(creature());
    const left = joints.filter((joint) => joint.part === 'part-2');
    assert.ok(left.length > 1);
    for (const {id, name, position: [x, y, z], radius} of left) {
      const twin = joints.find((joint) => joint.id === id.replace('part-2', 'part-2:twin'));
      assert.deepEqual(twin.position.map((c) => c.toFixed(9)), [x, y, -z].map((c) => c.toFixed(9)));
      assert.ok(Math.abs(twin.radius - radius) < 1e-9);
      assert.match(name, /\.L\./);
      assert.equal(twin.name, name.replace('.L.', '.R.'));
    }
  });

  claim('the OBJ holds each visible part, and the bones', () => {
    const document = creature();
    document.parts[4].visible = false;
    document.parts[2].name = 'hind leg\nv 1 2 3';
    const rig = rigOf(document, '--obj', 'rig.obj');
    const lines = read('rig.obj').split('\n');
    const rows = (word) => lines.filter((line) => line.startsWith(word + ' '))
        .map((line) => line.split(' ').slice(1));
    assert.deepEqual(rows('o').flat(), ['Body', 'Front_leg.L', 'Front_leg.R',
      'hind_leg_v_1_2_3.L', 'hind_leg_v_1_2_3.R', 'Head', 'Ear.L', 'Ear.R', 'Ball', 'bones']);
    const vertices = rows('v').map((row) => row.map(Number));
    assert.equal(rows('vn').length, vertices.length - rig.joints.length);
    for (const row of rows('vn')) {
      assert.ok(Math.abs(Math.hypot(...row.map(Number)) - 1) < 1e-9, 'unit normals');
    }
    assert.deepEqual(rows('l').map((row) => row.map((i) => vertices[i - 1])),
        rig.bones.map((bone) => bone.map((id) =>
          rig.joints.find((joint) => joint.id === id).position)));
    // Outward, and in space: the volume of a body that stands where the document places it.
    const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
    let volume = 0;
    const used = new Set();
    for (const row of rows('f')) {
      const [p, q, r] = row.map((corner) => {
        const [vertex, normal] = corner.split('//').map(Number);
        assert.equal(vertex, normal);
        used.add(vertex);
        return vertices[vertex - 1];
      });
      const [x, y, z] = cross(q, r);
      volume += (p[0] * x + p[1] * y + p[2] * z) / 6;
    }
    assert.equal(used.size, vertices.length - rig.joints.length);
    assert.ok(volume > 0);
    for (const axis of [0, 1, 2]) {
      const ears = vertices.filter(([x, y]) => x > 180 && x < 230 && y > 150);
      const middle = ears.reduce((sum, v) => sum + v[axis], 0) / ears.length;
      assert.ok(Math.abs(middle - [205, 152, 0][axis]) < 8, `ears stand on the head: ${middle}`);
    }
  });

  claim('the SVG shows parts, bones and joints from three sides', () => {
    const document = creature();
    document.parts[0].name = '<body> & "co"';
    document.parts[5].visible = false;
    const rig = rigOf(document, '--svg', 'rig.svg');
    const svg = read('rig.svg');
    assert.ok(svg.startsWith('<svg') && svg.endsWith('</svg>\n'));
    assert.ok(!/nan|inf/i.test(svg.replaceAll(/<text.*<\/text>/g, '')));
    assert.ok(svg.includes('&lt;body&gt; &amp; &quot;co&quot;'));
    for (const side of ['front', 'right', 'top']) {
      const view = svg.slice(svg.indexOf(`<g id="${side}"`)).split('<g id=')[1];
      const count = (group, shape) => view.split(`<g class="${group}"`)[1].split('</g>')[0]
          .split(shape).length - 1;
      assert.equal(count('parts', '<path'), 8);
      assert.equal(count('joints', '<circle'), rig.joints.length);
      assert.equal(count('roots', '<circle'), rig.roots.length);
      assert.equal(count('connections', '<polygon'), rig.connections.length);
    }
  });

  claim('without an output the rig is summed up', () => {
    const done = run('rig', write('creature.json', creature()));
    assert.equal(done.status, 0);
    assert.equal(done.stderr, '');
    assert.match(done.stdout, /^creature.json: 7 parts, 3 twins\n/);
    assert.match(done.stdout, /joints: \d+ \(\d+ terminal, \d+ sleeve, \d+ junction\), \d+ bones/);
    assert.match(done.stdout, /root: Body\.\d+ of Body \(part-1\)/);
    assert.match(done.stdout, /Head \(part-4\) hangs on Body \(part-1\) \((split|connect), by \w+\)/);
    assert.match(done.stdout, /Ear \(part-6:twin\) has no bones and moves with Head/);
    assert.match(done.stdout, /unattached: Ball \(part-7\)/);
  });

  claim('the same document gives the same rig', () => {
    write('creature.json', creature());
    const texts = ['a', 'b'].map((name) => {
      const rig = rigOf('creature.json', '--obj', name + '.obj', '--svg', name + '.svg');
      return JSON.stringify(untimed(rig)) + read(name + '.obj') + read(name + '.svg');
    });
    assert.equal(texts[0], texts[1]);
  });

  claim('larger thresholds leave fewer joints, the same roots and known ids', () => {
    const parts = creature().parts;
    parts[0].stroke.points = ellipse(170, 75, 200).map(([x, y], i) => {
      const bump = 1 + 0.25 * Math.sin(i / 200 * 14 * Math.PI);
      return [x * bump, y * bump];
    });
    const document = {...creature(), parts};
    for (const option of ['--eps-s', '--eps-m', '--eps-t', '--eps-c']) {
      const others = ['--eps-s', '--eps-m', '--eps-t', '--eps-c'].filter((one) => one !== option)
          .flatMap((one) => [one, '0']);
      let finer;
      for (const value of ['0', '1', '5', '20', '50', '150', '2000']) {
        const rig = rigOf(document, ...others, option, value);
        assert.ok(rig.unattached.includes('part-7'));
        if (finer) {
          assert.ok(rig.joints.length <= finer.joints.length, `${option} ${value}`);
          assert.deepEqual(rig.roots.map((id) => id.split('/')[0]),
              finer.roots.map((id) => id.split('/')[0]));
          assert.deepEqual(rig.connections, finer.connections);
        } else {
          finer = rig;
        }
      }
      const coarsest = rigOf(document, ...others, option, '2000').joints.length;
      if (option !== '--eps-m') assert.ok(coarsest < finer.joints.length, option);
    }
  });

  claim("options stand in for the document's own, narrower scopes still win", () => {
    const fine = rigOf(creature(), '--eps-s', '0'), coarse = rigOf(creature(), '--eps-s=500');
    assert.ok(coarse.joints.length < fine.joints.length);
    const global = {...creature(), refine: {simplify: 0}};
    assert.deepEqual(untimed(rigOf(global)), untimed(fine));
    assert.deepEqual(untimed(rigOf(global, '--eps-s', '500')), untimed(coarse));
    const own = creature();
    own.parts[0].refine = {simplify: 0};
    const jointsOf = (rig) => rig.joints.filter((joint) => joint.part === 'part-1').length;
    assert.equal(jointsOf(rigOf(own, '--eps-s', '500')), jointsOf(fine));
    assert.ok(jointsOf(coarse) < jointsOf(fine));
  });

  claim('what the user said about attachments is kept', () => {
    const document = creature();
    document.parts[6].attachment = {part: 'part-4', at: [0, 0]};
    document.parts[4].attachment = {part: '', at: [0, 0]};
    const rig = rigOf(document);
    const ball = rig.connections.find(({child}) => child === 'part-7');
    assert.deepEqual([ball.parent, ball.test], ['part-4', 'user']);
    assert.ok(!rig.connections.some(({child}) => child === 'part-5'));
    assert.deepEqual(rig.unattached, ['part-5']);
  });

  claim('a document may be empty or hold a part of which nothing comes', () => {
    const empty = rigOf({format: 'marrow', version: 1, parts: []}, '--obj', 'e.obj', '--svg', 'e.svg');
    assert.deepEqual([empty.joints, empty.bones, empty.roots], [[], [], []]);
    assert.ok(read('e.svg').startsWith('<svg'));
    const document = creature();
    document.parts[1].stroke.points = [[0, 0], [1, 1], [2, 2]];
    const rig = rigOf(document, '--obj', 'e.obj', '--svg', 'e.svg');
    assert.equal(rig.errors.length, 1);
    assert.equal(rig.errors[0].part, 'part-2');
    assert.ok(rig.errors[0].message.length > 10);
    assert.ok(!rig.joints.some((joint) => joint.part.startsWith('part-2')));
  });

  claim('60 parts are a document like any other', () => {
    const parts = Array.from({length: 60}, (_, i) => part(`part-${i + 1}`, 'Limb', limb(30, 120),
        {frame: at([30 * (i % 10), 60 * Math.floor(i / 10), 0])}));
    const rig = rigOf({format: 'marrow', version: 1, parts});
    assert.equal(new Set(rig.joints.map((joint) => joint.part)).size, 60);
  });

  const text = JSON.stringify(creature());
  const changed = (change) => {
    const document = creature();
    change(document);
    return document;
  };
  const badDocuments = {
    'empty': '', 'not JSON': 'marrow', 'a list': '[]', 'null': 'null', 'cut off': text.slice(0, -5),
    'another format': changed((document) => { document.format = 'narrow'; }),
    'no format': changed((document) => { delete document.format; }),
    'no version': changed((document) => { delete document.version; }),
    'a newer version': changed((document) => { document.version = 2; }),
    'version a text': changed((document) => { document.version = '1'; }),
    'a stroke alone': {name: 'x', closed: true, points: limb(20, 90)},
    'parts an object': changed((document) => { document.parts = {}; }),
    'a part a number': changed((document) => { document.parts[3] = 5; }),
    'a part without a stroke': changed((document) => { delete document.parts[3].stroke; }),
    'a point of three': changed((document) => { document.parts[3].stroke.points[2] = [1, 2, 3]; }),
    'a number too large': text.replace('-30', '-1e999'),
    'a frame that is none': changed((document) => { document.parts[1].frame.x = [0, 0, 0]; }),
    'a mirror without a normal': changed((document) => {
      document.parts[1].mirror = {plane: [0, 0, 0, 1]};
    }),
    'two parts of one id': changed((document) => { document.parts[3].id = 'part-1'; }),
    'an id with a colon': changed((document) => { document.parts[3].id = 'part-1:twin'; }),
    'a million brackets': '['.repeat(1e6),
  };
  for (const [name, content] of Object.entries(badDocuments)) {
    claim(`refuses a document: ${name}`, () => {
      checkRefused(['rig', write('bad document.json', content)], 'bad document.json: ');
    });
  }

  claim('meshes that can follow no bone are told of, and no pose is made of them', () => {
    const far = {format: 'marrow', version: 1, parts: [part('part-1', 'Far', limb(20, 90),
        {frame: at([1e40, 0, 0])})], poses: [{name: 'Wave'}]};
    const done = run('rig', write('far.json', far), '--parts', '--json', 'far.out');
    assert.equal(done.status, 0);
    assert.match(done.stderr, /^marrow: far.json: the meshes follow no bone: [^\n]+\.\n$/);
    const rig = JSON.parse(read('far.out'));
    assert.ok(rig.noWeights.length > 10 && !('weights' in rig));
    assert.equal(run('rig', 'far.json', '--parts', '--no-weights', '--json', 'far.out').stderr, '');
  });

  claim('seams are as soft as the document has them, unless --blend says otherwise', () => {
    const volume = (document, ...words) => {
      const done = run('rig', write('creature.json', document), '--merge', '--no-weights', '--json',
          'rig.json', ...words);
      assert.equal(done.status, 0, done.stderr);
      return JSON.parse(read('rig.json')).merged.volume;
    };
    const hard = volume(creature()), soft = volume({...creature(), blend: 20});
    assert.ok(soft > hard * 1.0001);
    assert.equal(volume(creature(), '--blend', '20'), soft);
    assert.equal(volume({...creature(), blend: 20}, '--blend=0'), hard);
    const posed = (...words) => {
      assert.equal(run('pose', write('creature.json', creature()), '--obj', 'p.obj', ...words)
          .status, 0);
      return read('p.obj');
    };
    assert.notEqual(posed('--blend', '20'), posed());
  });

  claim('refuses words that a rig does not know', () => {
    write('creature.json', creature());
    for (const words of [['rig'], ['rig', 'creature.json', 'creature.json'],
      ['rig', 'creature.json', '--thickness', '2'], ['rig', 'creature.json', '--eps', '2'],
      ['rig', 'nowhere.json'], ['rig', '.'], ['rig', '']]) {
      checkRefused(words, '');
    }
    for (const option of ['--eps-s', '--eps-m', '--eps-t', '--eps-c']) {
      for (const value of ['abc', '', 'nan', 'inf', '-1', '2001', '0x10', '1,5']) {
        checkRefused(['rig', 'creature.json', option, value], option);
      }
    }
    for (const words of [['--blend', '-1'], ['--blend', '1001'], ['--blend'], ['--scale', '0'],
      ['--scale', '1e10'], ['--gltf'], ['--gltf', 'same', '--glb', 'same']]) {
      checkRefused(['rig', 'creature.json', ...words], '');
    }
    assert.equal(run('rig', 'creature.json', '--json', 'creature.json').status, 2);
    assert.deepEqual(JSON.parse(read('creature.json')), creature());
  });

  claim('any broken copy of a document is a rig or a refusal', () => {
    const small = {format: 'marrow', version: 1, refine: {merge: 3}, parts: [
      part('part-1', 'A', ellipse(50, 30, 8), {mirror, refine: {branches: {b0: 3}}}),
      part('part-2', 'B', ellipse(10, 40, 8), {frame: at([40, 0, 9]), thickness: 0.5,
        attachment: {part: 'part-1:twin', at: [3, 4]}, root: true, color: '#12ab9f'}),
    ]};
    const whole = Buffer.from(JSON.stringify(small));
    let seed = 4711;
    const random = (below) => {
      seed = (Math.imul(seed, 1103515245) + 12345) >>> 0;
      return Math.floor(seed / 2 ** 32 * below);
    };
    let fine = 0;
    for (let i = 0; i < 300; ++i) {
      const bytes = Buffer.from(whole);
      for (let k = random(3); k >= 0; --k) bytes[random(bytes.length)] ^= 1 << random(8);
      const mutant = write('mutant.json', i % 7 === 0 ? bytes.subarray(0, random(bytes.length))
          : bytes);
      const done = run('rig', mutant, '--json', 'rig.json', '--obj', 'm.obj', '--svg', 'm.svg');
      assert.ok(done.status === 0 || done.status === 2, `${i}: ${done.status} ${done.signal}`);
      if (done.status === 2) {
        assert.match(done.stderr, /^marrow: mutant.json: [^\n]+\n$/);
      } else {
        checkRig(JSON.parse(read('rig.json')));
        ++fine;
      }
    }
    assert.ok(fine > 20, 'some are still documents');
  });

  claim('a GLB that it wrote is read like the document it was made of', () => {
    const file = write('creature.json', creature());
    assert.equal(run('rig', file, '--glb', 'one.glb', '--json', 'one.json').status, 0);
    assert.equal(run('rig', 'one.glb', '--glb', 'two.glb', '--json', 'two.json').status, 0);
    const [one, two] = ['one.json', 'two.json'].map((name) => JSON.parse(read(name)));
    assert.deepEqual(two.joints, one.joints);
    const done = run('rig', write('other.glb', 'glTF\x02\0\0\0'), '--json', 'x.json');
    assert.equal(done.status, 2);
    assert.match(done.stderr, /^marrow: other\.glb: [^\n]+\n$/);
  });

  claim('every sample is one sound character', () => {
    const files = fs.existsSync(samples)
        ? fs.readdirSync(samples).filter((name) => name.endsWith('.json')).sort() : [];
    if (!files.length) console.log('  skipped: no samples');
    for (const file of files) {
      const document = JSON.parse(fs.readFileSync(path.join(samples, file), 'utf8'));
      if (document.format !== 'marrow') continue;
      const rig = rigOf(path.join(samples, file));
      assert.deepEqual(rig.errors, [], file);
      assert.deepEqual(rig.unattached, [], file);
      assert.equal(rig.roots.length, 1, file);
    }
  });
}
