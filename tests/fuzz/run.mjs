// node run.mjs FOLDER [SECONDS]: runs the fuzzers that are in FOLDER, from the documents in
// tests/data. A fixed number of runs with a fixed seed, or for SECONDS each; what breaks one is
// kept in FOLDER/artifacts, where SECONDS are given what was found as well, in FOLDER/corpus. Exit
// code 77, which skips the test, where they are not built.
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import {fileURLToPath} from 'node:url';

const kRuns = {document: 8000, command: 1000};
const kLongest = {document: 4096, command: 800};  // bytes
const kSkipped = 77;

const [folder, seconds] = process.argv.slice(2);
const data = path.join(path.dirname(fileURLToPath(import.meta.url)), '..', 'data', 'documents');
const missing = Object.keys(kRuns).filter(
    (name) => !fs.existsSync(path.join(folder, `${name}_fuzzer`)));
if (missing.length > 0) {
  console.log(`fuzz: not built: ${missing.join(', ')}`);
  process.exit(process.env.CI ? 1 : kSkipped);
}

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
