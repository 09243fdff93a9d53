// node tests/bench/run.mjs [NAME…]: runs the benchmarks and prints one table, in Markdown.
//
// A benchmark is <name>.cpp (built natively and as WebAssembly for Node), <name>.py or
// <name>.bench.mjs (run by Node; for the real app in Chromium). Each writes a line a figure to its
// standard output, fields separated by tabs: table, row, n, milliseconds; anything else it writes
// to its standard error. A .bench.mjs adds a fifth field, the column, where it is not "Chromium".
import {spawnSync} from 'node:child_process';
import {existsSync, readdirSync} from 'node:fs';
import {cpus} from 'node:os';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const folder = dirname(fileURLToPath(import.meta.url));
const root = resolve(folder, '../..');
const names = process.argv.slice(2);
const figures = [];  // {table, row, n, column, ms}
let failed = false;

function run(name, column, command, ...args) {
  console.error(`bench: ${name}, ${column}`);
  const result = spawnSync(command, args, {
    cwd: root, encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'], maxBuffer: 1 << 26,
  });
  if (result.status !== 0) {
    console.error(`bench: ${name}, ${column}: failed`);
    failed = true;
  }
  for (const line of (result.stdout ?? '').split('\n')) {
    const fields = line.split('\t');
    if (fields.length < 4) continue;
    const [table, row, n, ms, own_column] = fields;
    figures.push({table, row, n, ms: Number(ms), column: own_column ?? column});
  }
}

// The Python that has scikit-image; a Python from elsewhere may come first on the path.
const python = existsSync('/usr/bin/python3') ? '/usr/bin/python3' : 'python3';

for (const file of readdirSync(folder).sort()) {
  const [, name, kind] = /^(\w+)\.(cpp|py|bench\.mjs)$/.exec(file) ?? [];
  if (!name || (names.length && !names.includes(name))) continue;
  if (kind === 'cpp') {
    run(name, 'native', join(root, `build/native/bench_${name}`));
    run(name, 'wasm', process.execPath, join(root, 'tests/node/run.cjs'),
        join(root, `build/wasm/bench_${name}.js`));
  } else if (kind === 'py') {
    run(name, 'native', python, join(folder, file));
  } else {
    run(name, 'Chromium', process.execPath, join(folder, file));
  }
}

const number = (ms) => (ms === undefined ? '' : ms < 0.0995 ? ms.toFixed(4) : ms < 9.95
    ? ms.toFixed(2) : ms.toFixed(ms < 99.5 ? 1 : 0));

function print(rows) {
  const widths = rows[0].map((_, i) => Math.max(...rows.map((row) => row[i].length)));
  const line = (row) => `| ${row.map((cell, i) => i < 1 ? cell.padEnd(widths[i])
                                                        : cell.padStart(widths[i])).join(' | ')} |`;
  console.log(line(rows[0]));
  console.log(`|${widths.map((w, i) => (i < 1 ? '-'.repeat(w + 2) : '-'.repeat(w + 1) + ':')).join('|')}|`);
  for (const row of rows.slice(1)) console.log(line(row));
}

console.log(`${cpus()[0]?.model ?? 'processor'}, ${cpus().length} cores; milliseconds`);
for (const table of new Set(figures.map((figure) => figure.table))) {
  const own = figures.filter((figure) => figure.table === table);
  const columns = ['native', 'wasm', 'Chromium'].filter((c) => own.some((f) => f.column === c));
  columns.push(...new Set(own.map((f) => f.column).filter((c) => !columns.includes(c))));
  const ratio = columns.includes('native') && columns.includes('wasm');
  const rows = [['', 'n', ...columns, ...(ratio ? ['wasm ÷ native'] : [])]];
  for (const key of new Set(own.map((f) => `${f.row}\t${f.n}`))) {
    const at = (column) => own.find((f) => `${f.row}\t${f.n}` === key && f.column === column)?.ms;
    const share = at('wasm') / at('native');
    rows.push([...key.split('\t'), ...columns.map((column) => number(at(column))),
               ...(ratio ? [Number.isFinite(share) ? share.toFixed(2) : ''] : [])]);
  }
  console.log(`\n**${table}**\n`);
  print(rows);
}
process.exitCode = failed || !figures.length ? 1 : 0;
