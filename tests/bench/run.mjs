// node tests/bench/run.mjs [--quick] [stages] [growth] [cold] [rig] [large] [model] [quality] [thinning] [frames]:
// measures all, or what is named, and prints the tables in Markdown. Everything measured goes to
// build/bench.json.
//
// The machine may be busy with other things: native and WebAssembly take turns, a few times over,
// and of each figure the smallest is kept (of medians the middle one).
import {spawnSync} from 'node:child_process';
import {existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync} from 'node:fs';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

import {frames} from './frames.mjs';
import {large} from './large.mjs';
import {report} from './report.mjs';

const folder = dirname(fileURLToPath(import.meta.url));
const root = resolve(folder, '../..');
const quick = process.argv.includes('--quick');
const named = process.argv.slice(2).filter((word) => !word.startsWith('-'));
const wanted = (name) => !named.length || named.includes(name);

function run(what, command, args, input) {
  const result = spawnSync(command, args, {
    input, encoding: 'utf8', maxBuffer: 1 << 28, stdio: ['pipe', 'pipe', 'inherit'],
  });
  if (result.status !== 0) throw new Error(`${what} failed`);
  return result.stdout.split('\n').filter(Boolean).map((line) => JSON.parse(line));
}

const programs = {
  native: [join(root, 'build/native/marrow_bench')],
  wasm: [process.execPath, join(root, 'tests/node/run.cjs'), join(root, 'build/wasm/marrow_bench.js')],
};

function bench(target, what, files = []) {
  const [command, ...args] = programs[target];
  return run(`${what}, ${target}`, command, [...args, what, ...(quick ? ['--quick'] : []), ...files])
      .map((row) => ({...row, target}));
}

/// The same figures measured several times, made one.
function merged(rows) {
  const groups = new Map();
  for (const {ms, runs, ...what} of rows) {
    const key = JSON.stringify(what);
    if (!groups.has(key)) groups.set(key, {what, all: []});
    groups.get(key).all.push(ms);
  }
  return [...groups.values()].map(({what, all}) => {
    const ms = {};
    for (const name of new Set(all.flatMap((times) => Object.keys(times)))) {
      const times = all.map((one) => one[name]).filter((time) => time !== undefined);
      const middle = (list) => list.sort((a, b) => a - b)[list.length >> 1];
      // Of the largest the smallest: what another program did to the others is not ours.
      ms[name] = Array.isArray(times[0])
          ? [Math.min(...times.map((time) => time[0])), middle(times.map((time) => time[1])),
             ...(times[0].length > 2 ? [Math.min(...times.map((time) => time[2]))] : [])]
          : middle(times);
    }
    return {...what, ms};
  });
}

function say(text) { console.error(`bench: ${text}`); }

/// The sample creatures.
function samples() {
  const from = join(root, 'public/samples');
  return (existsSync(from) ? readdirSync(from) : []).filter((name) => name.endsWith('.json')).sort()
      .map((name) => join(from, name))
      .filter((file) => JSON.parse(readFileSync(file, 'utf8')).format === 'marrow');
}

function repeated(what, times, files) {
  const rows = [];
  for (let i = 0; i < times; ++i) {
    for (const target of Object.keys(programs)) {
      say(`${what}, ${target}, ${i + 1} of ${times}`);
      rows.push(...bench(target, what, files));
    }
  }
  return merged(rows);
}

const rows = [];
const strokes = bench('native', 'strokes');
if (wanted('stages')) rows.push(...repeated('stages', quick ? 1 : 3));
if (wanted('growth')) rows.push(...repeated('growth', quick ? 1 : 2));
if (wanted('cold')) rows.push(...repeated('cold', quick ? 3 : 7));
if (wanted('rig')) rows.push(...repeated('rig', quick ? 1 : 4, samples()));
if (wanted('large')) {
  say('large characters');
  rows.push(...large(join(root, 'build/native/marrow'), {quick}));
}
if (wanted('model')) rows.push(...repeated('model', quick ? 1 : 4, samples()));
if (wanted('quality')) {
  say('quality');
  rows.push(...bench('native', 'quality'));
}
if (wanted('thinning')) {
  say('thinning');
  // The Python that has scikit-image; a Python from elsewhere may come first on the path.
  const python = existsSync('/usr/bin/python3') ? '/usr/bin/python3' : 'python3';
  const lines = strokes.map((stroke) => JSON.stringify(stroke)).join('\n');
  const found = run('thinning', python, [join(folder, 'thinning.py'), ...(quick ? ['--quick'] : [])],
                    lines);
  if (found[0]?.missing) {
    say(`scikit-image is missing (apt-get install python3-skimage): ${found[0].missing}`);
  } else {
    rows.push(...found);
  }
}
if (wanted('frames')) {
  const site = join(root, 'build/web');
  if (existsSync(join(site, 'marrow.wasm'))) {
    say('frames in Chromium');
    // Software rendering is slow: not all of them.
    const drawn = strokes.filter((_, i) => i % (quick ? 12 : 4) === 0);
    rows.push(...await frames(site, drawn, bench('native', 'character')[0].document, {quick}));
  } else {
    say('build/web is not there, so no frames in Chromium');
  }
}
mkdirSync(join(root, 'build'), {recursive: true});
writeFileSync(join(root, 'build/bench.json'), rows.map((row) => JSON.stringify(row)).join('\n') + '\n');
console.log(report(rows));
