// Figures → tables in Markdown, and what of the targets is reached.
import {readFileSync} from 'node:fs';
import {cpus, totalmem} from 'node:os';

const number = (x) => (x === undefined || !Number.isFinite(x) ? '–'
    : x < 0.0995 ? x.toFixed(4) : x < 9.95 ? x.toFixed(2) : x.toFixed(x < 99.5 ? 1 : 0));
const times = (x) => (x === undefined || !Number.isFinite(x) ? '–'
    : `${x < 9.95 ? x.toFixed(2) : x.toFixed(x < 99.5 ? 1 : 0)} ×`);
const mean = (list) => list.reduce((sum, x) => sum + x, 0) / list.length;
const least = (times) => times?.[0];

function table(rows) {
  const widths = rows[0].map((_, i) => Math.max(...rows.map((row) => [...row[i]].length)));
  const pad = (cell, i) => {
    const space = ' '.repeat(widths[i] - [...cell].length);
    return i < 1 ? cell + space : space + cell;
  };
  const line = (row) => `| ${row.map(pad).join(' | ')} |`;
  const rule = `|${widths.map((w, i) => (i < 1 ? '-'.repeat(w + 2) : `${'-'.repeat(w + 1)}:`)).join('|')}|`;
  return [line(rows[0]), rule, ...rows.slice(1).map(line)].join('\n');
}

/// The machine in words.
export function machine() {
  let speed = '';
  try {
    const mhz = /cpu MHz\s*:\s*([\d.]+)/.exec(readFileSync('/proc/cpuinfo', 'utf8'))?.[1];
    if (mhz) speed = ` at ${(mhz / 1000).toFixed(1)} GHz`;
  } catch { /* another system */ }
  const memory = Math.round(totalmem() / 2 ** 30);
  return `${cpus()[0]?.model ?? 'unknown processor'}${speed}, ${cpus().length} cores, ` +
      `${memory} GB of memory, Node ${process.versions.node}`;
}

const modes = ['1000', '2500', 'preview'];
const targets = ['native', 'wasm'];

class Figures {
  constructor(rows) { this.rows = rows; }
  all(bench, what = {}) {
    return this.rows.filter((row) => row.bench === bench &&
        Object.entries(what).every(([key, value]) => row[key] === value));
  }
  one(bench, what) { return this.all(bench, what)[0]; }
  has(bench) { return this.rows.some((row) => row.bench === bench); }
}

/// Mean over the strokes of a stage's least time.
function stageMean(figures, target, mode, stage) {
  return mean(figures.all('stages', {target, mode}).map((row) => row.ms[stage][0]));
}

function stageNames(figures) {
  return Object.keys(figures.one('stages', {target: 'native', mode: '1000'}).ms);
}

const label = {toJoints: '**outline … joints**', total: '**whole stroke**'};

function stageTable(figures) {
  const count = figures.all('stages', {target: 'native', mode: '1000'}).length;
  const head = ['stage'];
  for (const mode of modes) {
    const vertices = Math.round(mean(figures.all('stages', {target: 'native', mode})
        .map((row) => row.vertices)));
    head.push(`${mode === 'preview' ? 'preview, ' : ''}${vertices} vertices: native`, 'wasm', '÷');
  }
  const rows = stageNames(figures).map((stage) => {
    const row = [label[stage] ?? stage];
    for (const mode of modes) {
      const [native, wasm] = targets.map((target) => stageMean(figures, target, mode, stage));
      row.push(number(native), number(wasm), number(wasm / native));
    }
    return row;
  });
  return `### Stages, mean of ${count} strokes (ms)\n\n${table([head, ...rows])}`;
}

function strokeTable(figures) {
  const thinning = figures.has('thinning');
  const head = ['stroke', 'samples', 'polygon', 'outline … joints: native', 'wasm',
                '1,000 vertices: native', 'wasm', '2,500: native', 'wasm', 'preview: native', 'wasm'];
  if (thinning) head.push('Zhang–Suen', '÷ outline … joints');
  const rows = figures.all('stages', {target: 'native', mode: '1000'}).map((first) => {
    const {stroke} = first;
    const at = (target, mode, name) =>
        least(figures.one('stages', {stroke, target, mode})?.ms[name]);
    const row = [stroke, String(first.samples), String(first.polygon)];
    for (const target of targets) row.push(number(at(target, '1000', 'toJoints')));
    for (const mode of modes) {
      for (const target of targets) row.push(number(at(target, mode, 'total')));
    }
    if (thinning) {
      const thinned = least(figures.one('thinning', {stroke})?.ms.zhangSuen);
      row.push(number(thinned), times(thinned / at('native', '1000', 'toJoints')));
    }
    return row;
  });
  return `### Strokes (ms)\n\n${table([head, ...rows])}`;
}

function polygonTable(figures) {
  const head = ['polygon of', 'n', ...targets.flatMap((target) =>
      [`${target}: ours`, 'CGAL', 'chordal axis', 'CGAL ÷ ours', 'chordal ÷ ours'])];
  const rows = figures.all('polygons', {target: 'native'}).map(({stroke, n}) => [stroke, String(n),
    ...targets.flatMap((target) => rivalCells(figures.one('polygons', {stroke, target})))]);
  return `### Straight skeletons of the strokes' polygons (ms)\n\n${table([head, ...rows])}`;
}

function rivalCells(row) {
  const {ours, cgal, chordal} = row?.ms ?? {};
  return [number(least(ours)), number(least(cgal)), number(least(chordal)),
          times(least(cgal) / least(ours)), times(least(chordal) / least(ours))];
}

function growthTable(figures) {
  const head = ['family', 'n', ...targets.flatMap((target) =>
      [`${target}: ours`, 'CGAL', 'chordal axis', 'CGAL ÷ ours', 'chordal ÷ ours']),
                'ours: wasm ÷ native'];
  const rows = figures.all('growth', {target: 'native'}).map(({family, n}) => {
    const [native, wasm] = targets.map((target) => figures.one('growth', {family, n, target}));
    return [family, String(Math.round(n)), ...rivalCells(native), ...rivalCells(wasm),
            number(least(wasm?.ms.ours) / least(native.ms.ours))];
  });
  const powers = [['family', ...targets.flatMap((target) =>
      [`${target}: ours`, 'CGAL', 'chordal axis'])]];
  for (const family of new Set(figures.all('growth').map((row) => row.family))) {
    powers.push([family, ...targets.flatMap((target) => ['ours', 'cgal', 'chordal'].map((who) =>
        number(slope(figures.all('growth', {family, target}), who))))]);
  }
  return `### Straight skeletons as the polygon grows (ms)\n\n${table([head, ...rows])}\n\n` +
      `Growth from 100 vertices on, as a power of n (n² log n is ${
        number(bestSlope())} there)\n\n${table(powers)}`;
}

function qualityTable(figures) {
  const cell = (value, unit) => `${Number(value.toPrecision(3))}${unit && ` ${unit}`}`;
  const rows = figures.all('quality').map((row) => {
    const most = row.most !== undefined, wanted = most ? row.most : row.least;
    const good = most ? row.value <= wanted : row.value >= wanted;
    return [row.what, `${most ? '≤' : '≥'} ${cell(wanted, row.unit)}`, cell(row.value, row.unit),
            row.note, good ? '✓' : '✗'];
  });
  return `### Rig quality\n\n${table([['figure', 'wanted', 'measured', 'of', ''], ...rows])}`;
}

/// By least squares, of log(ms) over log(n).
function slopeOf(points) {
  const xs = points.map(([x]) => Math.log(x)), ys = points.map(([, y]) => Math.log(y));
  const [mx, my] = [mean(xs), mean(ys)];
  const over = xs.reduce((sum, x, i) => sum + (x - mx) * (ys[i] - my), 0);
  return over / xs.reduce((sum, x) => sum + (x - mx) ** 2, 0);
}

function slope(rows, who) {
  const points = rows.filter((row) => row.n >= 100 && row.ms[who])
      .map((row) => [row.n, least(row.ms[who])]);
  return points.length > 2 ? slopeOf(points) : NaN;
}

function bestSlope() {
  return slopeOf([100, 135, 200, 400, 1000, 2000].map((n) => [n, n * n * Math.log(n)]));
}

function coldTable(figures) {
  const head = ['call in a new process', ...targets.flatMap((target) =>
      [`${target}: outline … joints`, 'whole stroke'])];
  const rows = figures.all('cold', {target: 'native'}).map(({call}) => [String(call),
    ...targets.flatMap((target) => {
      const ms = figures.one('cold', {target, call})?.ms;
      return [number(ms?.toJoints), number(ms?.total)];
    })]);
  return `### First calls, nothing warmed up (ms, the typical stroke)\n\n${table([head, ...rows])}`;
}

function frameTable(figures) {
  const head = ['stroke', 'previews', 'preview: median', 'largest', 'frame: median', 'largest',
                'finished part'];
  const cells = (row) => [row.stroke, String(row.previews), number(row.previewMedian),
                          number(row.previewMax), number(row.frameMedian), number(row.frameMax),
                          number(row.part)];
  const first = figures.all('firstStroke').map((row) =>
      [`the very first: ${row.stroke}`, ...cells({...row, frameMedian: NaN, frameMax: NaN}).slice(1)]);
  const sizes = figures.all('size').map((row) => [row.file, ...[row.raw, row.gzip, row.brotli]
      .map((bytes) => `${(bytes / 1000).toFixed(0)} kB`)]);
  const ready = figures.all('firstStroke').map((row) => `${Math.round(row.ready)}`).join(', ');
  return `### The frame loop in Chromium ${figures.one('firstStroke')?.version ?? ''}, drawing ` +
      `calls left out of the frame (ms)\n\n${table([head, ...first, ...figures.all('frames').map(cells)])}\n\n` +
      `Ready to be drawn on, since the navigation, from localhost: ${ready} ms.\n\n` +
      table([['file', 'bytes', 'gzip -9', 'brotli'], ...sizes]);
}

const kCharacter = 8;  // parts, in the targets

/// As if the creature had eight parts.
const perCharacter = (row) => least(row.ms.total) * kCharacter / row.parts;

function rigTable(figures) {
  const made = ['outline', 'straightSkeleton', 'axis', 'joints'];
  const stages = Object.keys(figures.one('rig').ms).filter((stage) => !made.includes(stage));
  const cells = (row) => [made.reduce((sum, stage) => sum + least(row?.ms[stage]), 0),
                          ...stages.map((stage) => least(row?.ms[stage]))].map(number);
  const head = ['character', 'strokes', 'parts', 'joints', ...targets.flatMap((target) =>
      [`${target}: outline … joints`, ...stages, 'opened'])];
  const rows = figures.all('rig', {target: 'native'}).map(({creature, strokes, parts, joints}) => [
    creature, String(strokes), String(parts), String(joints),
    ...targets.flatMap((target) => [...cells(figures.one('rig', {creature, target})),
      number(least(figures.one('open', {creature, target})?.ms.total))])]);
  return `### From strokes to rig, meshes apart, and whole documents opened (ms; parts with twins, ` +
      `which share skeletons)\n\n${table([head, ...rows])}`;
}

/// Each beside a tenth of its parts.
function largeTable(figures) {
  const rows = [['character', 'parts', 'vertices', 'to body and weights', '÷ of a tenth', 'MB',
                 '÷ of a tenth']];
  const all = figures.all('large');
  for (let i = 1; i < all.length; i += 2) {
    const [few, many] = [all[i - 1], all[i]];
    rows.push([many.creature, String(many.parts), String(many.vertices), `${number(many.ms.total)} ms`,
               number(many.ms.total / few.ms.total), number(many.megabytes),
               number(many.megabytes / few.megabytes)]);
  }
  return `### Large characters\n\n${table(rows)}`;
}

function updateTable(figures) {
  const head = ['one update of', 'what changes', ...targets.flatMap((target) =>
      [`${target}: least`, 'median', 'largest'])];
  const rows = ['drag', 'slider'].flatMap((bench) => figures.all(bench, {target: 'native'})
      .flatMap(({creature, ms}) => Object.keys(ms).map((what) => [creature,
        bench === 'drag' ? "a part's place" : `ε of ${what}`, ...targets.flatMap((target) =>
            [0, 1, 2].map((i) => number(figures.one(bench, {creature, target})?.ms[what][i])))])));
  return `### Dragging and refining (ms)\n\n${table([head, ...rows])}`;
}

function rigTargets(figures, atMost) {
  const largest = (rows, of) => rows.map((row) => [of(row), row.creature])
      .sort((a, b) => b[0] - a[0])[0];
  for (const [target, limit] of [['native', 0.6], ['wasm', 1]]) {
    const rows = figures.all('rig', {target});
    const ours = rows.find((row) => row.strokes === kCharacter && row.parts === kCharacter);
    const others = rows.filter((row) => row !== ours && row.strokes < 2 * kCharacter);
    const [slowest, creature] = largest(others, perCharacter) ?? [];
    atMost(`strokes to rig, a character of ${kCharacter} parts, ${target}`, limit, 'ms',
           least(ours.ms.total), creature === undefined ? '' : `; per ${kCharacter} parts the samples ${
             number(mean(others.map(perCharacter)))}, slowest ${number(slowest)} (${creature})`);
  }
  const most = figures.all('drag', {target: 'wasm'}).sort((a, b) => b.strokes - a.strokes)[0];
  atMost(`dragging one part among ${most.strokes}, wasm, every frame's evaluation`, 4, 'ms',
         most.ms.update[2], `, median ${number(most.ms.update[1])}`);
  const sliders = figures.all('slider', {target: 'wasm'}).sort((a, b) => b.strokes - a.strokes)[0];
  const [slider, name] = Object.entries(sliders.ms).map(([what, ms]) => [ms[1], what])
      .sort((a, b) => b[0] - a[0])[0];
  atMost(`a refinement slider, ${sliders.strokes} strokes, wasm`, 1, 'ms', slider,
         `, single slowest ${number(Math.max(...Object.values(sliders.ms).map((ms) => ms[2])))} (${
           name})`);
  const opened = figures.all('open', {target: 'wasm'});
  const large = opened.reduce((a, b) => (a.strokes > b.strokes ? a : b));
  atMost(`opening a document of ${large.strokes} strokes, wasm`, 300, 'ms', large.ms.total[1]);
  const [slowest, sample] = largest(opened.filter((row) => row !== large),
                                    (row) => row.ms.total[1]);
  atMost('opening a sample, the slowest, wasm', 200, 'ms', slowest, ` (${sample})`);
}

const largestOf = (rows, of) => rows.reduce((a, b) => (of(b) > of(a) ? b : a));

function modelTable(figures) {
  const cells = (bench, of) => figures.all(bench, {target: 'native'}).flatMap((row) => {
    const wasm = figures.all(bench, {target: 'wasm'})
        .find((other) => other.solids === row.solids && other.creature === row.creature);
    return Object.keys(row.ms).map((name) => [of(row, name),
      ...[row, wasm].flatMap((one) => [least(one?.ms[name]), one?.ms[name][1]]).map(number)]);
  });
  return `### Characters merged, weighted, posed, written (ms)\n\n${table([
    ['what', 'native: least', 'median', 'wasm: least', 'median'],
    ...cells('merge', (row) => `merge: ${row.solids}, ${row.vertices} vertices`),
    ...cells('weights', (row, name) => `weights${name === 'firstGuess' ? ', first guess' : ''}: ${
      row.creature}, ${row.bones} bones, ${row.volume} volume vertices`),
    ...cells('pose', (row, name) => name === 'joints' ? `the ${row.joints} joints alone`
        : `posing ${row.vertices} vertices, ${row.joints} joints: ${name}`),
    ...cells('reach', (row, name) => `inverse kinematics, ${row.joints} joints: ${name}`),
    ...cells('glb', (row) => `GLB: ${row.creature}, ${row.vertices} vertices`)])}`;
}

function modelTargets(figures, atMost) {
  for (const [target, limit] of [['native', 60], ['wasm', 80]]) {
    const [plain, ...rest] = figures.all('merge', {target});
    const hard = rest.filter((row) => row.parts === plain.parts);
    const time = (row) => least(row.ms.total);
    atMost(`merge of ${plain.parts} parts, ${plain.vertices} vertices, ${target}`, limit, 'ms',
           time(plain));
    const slowest = largestOf(hard, time);
    atMost(`the same mirrored, coplanar and coincident, slowest, ${target}`, 3 * limit, 'ms',
           time(slowest), ` (${slowest.solids})`);
    const many = rest.find((row) => row.parts > plain.parts);
    if (target === 'wasm') {
      atMost(`merge of ${many.solids}, ${many.vertices} vertices, wasm`, 800, 'ms', time(many));
    }
  }
  for (const [target, limit] of [['native', 500], ['wasm', 1000]]) {
    const [ours, ...others] = figures.all('weights', {target});
    const note = (name) => {
      if (!others.length) return '';
      const slowest = largestOf(others, (row) => least(row.ms[name]));
      return `; the samples, 21 to 53 bones, slowest ${number(least(slowest.ms[name]))} (${
        slowest.creature})`;
    };
    atMost(`weights of ${ours.bones} bones, ${ours.volume} volume vertices, ${target}`, limit, 'ms',
           least(ours.ms.total), note('total'));
    atMost(`a first guess at them, ${target}`, 20, 'ms', least(ours.ms.firstGuess),
           note('firstGuess'));
  }
  for (const target of targets) {
    const {vertices, joints, ms} = figures.one('pose', {target});
    atMost(`posing ${vertices} vertices with ${joints} joints, ${target}`, 1, 'ms', least(ms.linear),
           ` linear, ${number(least(ms.dualQuaternions))} dual quaternions`);
  }
  const {joints, ms} = figures.one('reach', {target: 'wasm'});
  const dragged = Object.values(ms);
  atMost(`inverse kinematics of ${joints} joints, wasm`, 0.5, 'ms',
         Math.max(...dragged.map((times) => times[1])),
         ` median, single slowest ${number(Math.max(...dragged.map((times) => times[2])))}`);
  const glb = largestOf(figures.all('glb', {target: 'wasm'}), (row) => least(row.ms.write));
  atMost(`GLB of ${glb.vertices} vertices written, wasm`, 100, 'ms', least(glb.ms.write));
}

function targetTable(figures) {
  const rows = [['target', 'wanted', 'measured', '']];
  const add = (what, wanted, measured, good) => {
    rows.push([what, wanted, measured, good === undefined ? '' : good ? '✓' : '✗']);
  };
  const atMost = (what, limit, unit, value, note = '') =>
    add(what, `≤ ${limit} ${unit}`, `${number(value)} ${unit}${note}`, value <= limit);

  if (figures.has('growth')) {
    const growth = figures.all('growth');
    for (const target of targets) {
      const of = (who, rows) => rows.filter((row) => row.target === target && row.ms[who])
          .map((row) => [least(row.ms[who]) / least(row.ms.ours), `${row.family}, ${Math.round(row.n)}`])
          .sort((a, b) => a[0] - b[0]);
      const cgal = of('cgal', growth.filter((row) => row.n >= 20 && row.n <= 200));
      add(`CGAL's straight skeleton ÷ ours, 20 to 200 vertices, ${target}`, '≥ 30 ×',
          `${times(cgal[0][0])} (${cgal[0][1]}) to ${times(cgal.at(-1)[0])}`, cgal[0][0] >= 30);
      for (const [sizes, from, to] of [['10 to 200', 0, 200], ['400 to 2,000', 201, 9999]]) {
        const chordal = of('chordal', growth.filter((row) => row.n >= from && row.n <= to));
        const [worst, best] = [chordal[0], chordal.at(-1)];
        add(`chordal axis ÷ our straight skeleton, ${sizes} vertices, ${target}`, '≥ 1 ×',
            `${times(worst[0])} (${worst[1]}) to ${times(best[0])} (${best[1]})`, worst[0] >= 1);
      }
      const powers = [...new Set(growth.map((row) => row.family))]
          .map((family) => slope(growth.filter((row) => row.family === family &&
                                                        row.target === target), 'ours'));
      add(`growth of ours, 100 to 2,000 vertices, ${target}`, `n² log n, n^${number(bestSlope())}`,
          powers.map((power) => `n^${number(power)}`).join(', '),
          Math.max(...powers) <= bestSlope());
    }
  }
  if (figures.has('stages')) {
    const worst = (target, mode, name) => figures.all('stages', {target, mode})
        .map((row) => [least(row.ms[name]), row.stroke]).sort((a, b) => b[0] - a[0])[0];
    const typical = (target, mode, name) =>
        least(figures.all('stages', {target, mode})[0].ms[name]);
    const both = (what, limit, target, mode, name) => {
      const [slowest, stroke] = worst(target, mode, name);
      atMost(`${what}, ${target}`, limit, 'ms', typical(target, mode, name),
             `, slowest ${number(slowest)} (${stroke})`);
    };
    both('outline … joints, typical stroke', 1, 'native', '1000', 'toJoints');
    both('outline … joints, typical stroke', 2, 'wasm', '1000', 'toJoints');
    both('stroke to finished part, 1,000 vertices', 5, 'wasm', '1000', 'total');
    both('stroke to finished part, 2,500 vertices', 8, 'wasm', '2500', 'total');
    both('live preview in Node', 2.5, 'wasm', 'preview', 'total');
    for (const mode of modes) {
      const ratios = stageNames(figures).map((stage) =>
          [stageMean(figures, 'wasm', mode, stage) / stageMean(figures, 'native', mode, stage), stage])
          .sort((a, b) => b[0] - a[0]);
      add(`wasm ÷ native, stage by stage, ${mode}`, '≤ 2 ×', ratios.slice(0, 3)
          .map(([ratio, stage]) => `${stage} ${times(ratio)}`).join(', '), ratios[0][0] <= 2);
    }
  }
  if (figures.has('rig')) rigTargets(figures, atMost);
  if (figures.has('merge')) modelTargets(figures, atMost);
  const dragged = figures.one('dragFrames');
  if (dragged) {
    atMost(`dragging one part among ${dragged.strokes} in Chromium, every frame's evaluation`, 4,
           'ms', dragged.max, `, median ${number(dragged.median)} of ${dragged.frames} frames`);
  }
  if (figures.has('frames')) {
    const frames = figures.all('frames');
    const most = (rows, key) => rows.reduce((a, b) => (a[key] > b[key] ? a : b));
    const slowest = most(frames, 'previewMax');
    atMost('live preview in Chromium, median', 2.5, 'ms',
           most(frames, 'previewMedian').previewMedian,
           `, single slowest ${number(slowest.previewMax)} (${slowest.stroke})`);
    const part = most(frames, 'part');
    atMost('finished part in Chromium, slowest', 5, 'ms', part.part, ` (${part.stroke})`);
    add('a whole frame while drawing, without WebGL', '–', `${number(most(frames, 'frameMedian')
        .frameMedian)} ms, single slowest ${number(most(frames, 'frameMax').frameMax)}`);
    const first = figures.all('firstStroke');
    atMost('the very first stroke: slowest preview', 16.7, 'ms', most(first, 'previewMax').previewMax,
           `, finished part ${number(most(first, 'part').part)}`);
    atMost('ready to be drawn on', 1500, 'ms', most(first, 'ready').ready);
    const size = figures.all('size').filter((row) => row.file.endsWith('.wasm'))
        .reduce((sum, row) => sum + row.gzip, 0) / 1e6;
    atMost("the app's wasm, gzip -9", 1.2, 'MB', size);
  }
  return `### Targets\n\n${table(rows)}`;
}

export function report(rows) {
  const figures = new Figures(rows);
  const sections = [`${machine()}. Smallest of repeated runs.`];
  if (figures.has('quality')) sections.push(qualityTable(figures));
  sections.push(targetTable(figures));
  if (figures.has('stages')) {
    sections.push(stageTable(figures), strokeTable(figures), polygonTable(figures));
  }
  if (figures.has('growth')) sections.push(growthTable(figures));
  if (figures.has('rig')) sections.push(rigTable(figures), updateTable(figures));
  if (figures.has('large')) sections.push(largeTable(figures));
  if (figures.has('merge')) sections.push(modelTable(figures));
  if (figures.has('cold')) sections.push(coldTable(figures));
  if (figures.has('frames')) sections.push(frameTable(figures));
  return sections.join('\n\n');
}
