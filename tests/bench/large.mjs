// Large characters: a chain of different links, one of equal links, and copies in the same place,
// through `marrow rig --merge`. What counts is how time and memory grow: rows have both, and those
// of a tenth of the parts to compare with.
import {spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

/// A long blob; `kind` changes its outline.
function stroke(kind) {
  return Array.from({length: 60}, (_, i) => {
    const t = 2 * Math.PI * i / 60;
    const far = 1 + [2, 3, 4, 5].reduce(
        (sum, k) => sum + 0.1 * Math.sin(k * 12.9898 * (kind + 1)) * Math.sin(k * t + kind * k), 0);
    return [60 * far * Math.cos(t), 30 * far * Math.sin(t)];
  });
}

function character(count, kindOf, step) {
  return {
    format: 'marrow', version: 1,
    parts: Array.from({length: count}, (_, i) => ({
      stroke: {points: stroke(kindOf(i))}, frame: {origin: [step * i, 0, 0]},
    })),
  };
}

const kCharacters = {
  'chain': {count: 500, kindOf: (i) => i, step: 90},
  'long chain': {count: 5000, kindOf: (i) => i, step: 90},
  'chain of equal links': {count: 500, kindOf: () => 0, step: 90},
  'copies in the same place': {count: 300, kindOf: () => 0, step: 0},
};

export function large(program, {quick = false} = {}) {
  const folder = mkdtempSync(join(tmpdir(), 'marrow-large-'));
  const rows = [];
  try {
    for (const [name, {count, kindOf, step}] of Object.entries(kCharacters)) {
      if (quick && count > 500) continue;
      for (const parts of [count / 10, count]) {
        const file = join(folder, 'in.json'), out = join(folder, 'out.json');
        writeFileSync(file, JSON.stringify(character(parts, kindOf, step)));
        const start = performance.now();
        const run = spawnSync('/usr/bin/time', ['-f', '%M', program, 'rig', file, '--merge', '--json', out],
                              {encoding: 'utf8'});
        const total = performance.now() - start;
        if (run.status !== 0) throw new Error(`${name}, ${parts} parts: ${run.stderr}`);
        const {merged, connections} = JSON.parse(readFileSync(out, 'utf8'));
        rows.push({bench: 'large', creature: name, parts, vertices: merged.vertices,
                   connections: connections.length, ms: {total}, megabytes: Number(run.stderr) / 1000});
      }
    }
  } finally {
    rmSync(folder, {recursive: true});
  }
  return rows;
}
