// node schema.test.mjs: the documents' JSON Schema accepts what is sound, the samples and what the
// reader accepts too, and refuses what the reader refuses (tests/io/document_files_test.cpp reads
// the same lists).
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {fileURLToPath} from 'node:url';
import Ajv from 'ajv/dist/2020.js';

const root = path.join(path.dirname(fileURLToPath(import.meta.url)), '..', '..');
const read = (...names) => JSON.parse(fs.readFileSync(path.join(root, ...names), 'utf8'));
const schema = read('public', 'document.schema.json');
const validate = new Ajv(
    {allErrors: true, strict: true, strictTypes: false, strictRequired: false}).compile(schema);

function assertSound(name, document) {
  assert.ok(validate(document), `${name}: ${JSON.stringify(validate.errors)}`);
}

const good = Object.entries(read('tests', 'data', 'documents', 'good.json'));
const bad = Object.entries(read('tests', 'data', 'documents', 'bad.json'));
assert.ok(good.length >= 5 && bad.length >= 50);
for (const [name, document] of good) assertSound(name, document);
for (const [name, document] of bad) assert.ok(!validate(document), `${name} is accepted`);

const samples = path.join(root, 'public', 'samples');
const files = fs.existsSync(samples) ? fs.readdirSync(samples) : [];
for (const name of files.filter((file) => file.endsWith('.json'))) {
  const document = read('public', 'samples', name);
  if (document.format === 'marrow') assertSound(name, document);
}

// Every field is described, and none of the document that has all of them is left out.
function closed(node, name = '') {
  if (node === null || typeof node !== 'object' || Array.isArray(node)) return node;
  const copy = Object.fromEntries(
      Object.entries(node).map(([key, inner]) => [key, closed(inner, key)]));
  if (!node.properties) return copy;
  for (const [key, field] of Object.entries(node.properties)) {
    assert.ok(field.description, `${key} has no description`);
  }
  return name === 'refinement' ? copy : {...copy, unevaluatedProperties: false};
}
const strict = new Ajv({strictTypes: false}).compile(closed(schema));
const {'every-field': whole, 'unknown-fields': more} = Object.fromEntries(good);
assert.ok(strict(whole), JSON.stringify(strict.errors));
assert.ok(!strict(more));
console.log(`schema: ${good.length} documents and ${files.length} samples accepted, ` +
            `${bad.length} refused`);
