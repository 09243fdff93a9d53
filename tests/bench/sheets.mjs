// node sheets.mjs PROGRAM [--before OTHER] FILE_OR_FOLDER… OUT_FOLDER: contact sheets of rigs, 36
// tiles a sheet, as PNG. PROGRAM and OTHER: builds of the command line; with OTHER, its rig is on
// the left and PROGRAM's on the right.
//
// A file is a stroke, a document, or a drawing of tests/data/characters, whose placed joints and
// wanted limbs are crosses then. Rigs are as refined as the file says, seen from the front. Red:
// ends; blue: joints on the way; orange: where bones meet.
import {execFile, spawnSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {fileURLToPath} from 'node:url';
import {promisify} from 'node:util';

const tileSize = 320, columns = 6, tilesPerSheet = 36, captionHeight = 18, margin = 10;
const shared = fileURLToPath(new URL('../../../shared', import.meta.url));
const kinds = {
  sleeve: {radius: 3, color: '#2850a0'},
  terminal: {radius: 4, color: '#d83020'},
  junction: {radius: 4.5, color: '#f0a000'},
};

const isDocument = (json) => json.format === 'marrow';

/// Files as named, and those of folders by name.
function filesOf(names) {
  return names.flatMap((name) => !fs.statSync(name).isDirectory() ? [name]
      : fs.readdirSync(name).filter((file) => file.endsWith('.json')).sort()
          .map((file) => path.join(name, file)));
}

/// {name, document, crosses: [{at, wanted}]}, or null for a file that is none of ours.
function readDrawing(file) {
  const json = JSON.parse(fs.readFileSync(file, 'utf8'));
  const name = path.basename(file, '.json');
  if (isDocument(json)) return {name, document: json, crosses: []};
  let {points} = json;
  if (!points && json.outline) {  // of a stroke that is beside the project, or not
    const outline = path.join(shared, json.outline);
    if (fs.existsSync(outline)) points = JSON.parse(fs.readFileSync(outline, 'utf8')).points;
  }
  if (!points) return null;
  const document = {format: 'marrow', version: 1, parts: [{id: 'part-1', stroke: {points}}]};
  const cross = (at, wanted) => ({at, wanted});
  const crosses = [
    ...Object.values(json.joints ?? {}).map((at) => cross(at, true)),
    ...(json.limbs ?? []).flatMap(({tip, base}) => [cross(tip, true), cross(base, true)]),
    ...(json.allowed ?? []).map(({tip}) => cross(tip, false)),
  ];
  return {name, document, crosses};
}

/// Points of the part's plane, or of its own space, in space.
function toWorld({origin = [0, 0, 0], x = [1, 0, 0], y = [0, 1, 0]} = {}) {
  const length = Math.hypot(...x);
  const z = [0, 1, 2].map((i) => {
    const [j, k] = [(i + 1) % 3, (i + 2) % 3];
    return (x[j] * y[k] - x[k] * y[j]) / length;
  });
  return ([a, b, c = 0]) => origin.map((o, i) => o + a * x[i] + b * y[i] + c * z[i]);
}

function reflection([nx, ny, nz, d]) {
  const n = [nx, ny, nz], square = nx * nx + ny * ny + nz * nz;
  return (p) => {
    const k = 2 * (n.reduce((sum, m, i) => sum + m * p[i], d)) / square;
    return p.map((q, i) => q - k * n[i]);
  };
}

function unpacked(base64, Numbers) {
  const bytes = Uint8Array.from(Buffer.from(base64, 'base64'));
  return new Numbers(bytes.buffer);
}

function triples(numbers) {
  return Array.from({length: numbers.length / 3}, (_, i) => [...numbers.slice(3 * i, 3 * i + 3)]);
}

/// So that of the triangles of a body the far ones do not cancel the near ones.
function counterClockwise(points) {
  const area = points.reduce((sum, [x, y], i) => {
    const [u, v] = points[(i + 1) % points.length];
    return sum + x * v - u * y;
  }, 0);
  return area < 0 ? [...points].reverse() : points;
}

/// Closed lines as seen from the front, each with whether its rim is drawn: strokes and their twins,
/// and the triangles of imported parts.
function outlinesOf(document) {
  return document.parts.flatMap((part) => {
    const world = toWorld(part.frame);
    let rings;
    if (part.mesh) {
      const corners = triples(unpacked(part.mesh.positions, Float32Array)).map(world);
      rings = triples(unpacked(part.mesh.triangles, Uint32Array)).map((t) => t.map((i) => corners[i]));
    } else {
      rings = [part.stroke.points.map(world)];
    }
    if (part.mirror) rings.push(...rings.map((ring) => ring.map(reflection(part.mirror.plane))));
    return rings.map((points) => ({points: counterClockwise(points), rim: !part.mesh}));
  });
}

/// {joints, bones} of `program rig`, or {fault}.
async function rigOf(program, document, scratch) {
  const files = ['in', 'out'].map((end) => `${scratch}.${end}.json`);
  fs.writeFileSync(files[0], JSON.stringify(document));
  try {
    await promisify(execFile)(program, ['rig', files[0], '--json', files[1]], {maxBuffer: 1 << 28});
    const rig = JSON.parse(fs.readFileSync(files[1], 'utf8'));
    return rig.joints.length ? rig : {fault: 'no bones'};
  } catch (error) {
    return {fault: (error.stderr || error.message).trim().split('\n')[0]};
  } finally {
    for (const file of files) fs.rmSync(file, {force: true});
  }
}

const escaped = (text) => text.replace(/[&<>]/g, (c) => `&#${c.charCodeAt(0)};`);

/// One drawing with one rig as SVG, with its left upper corner at the origin.
function tile({name, document, crosses}, rig, caption) {
  const outlines = outlinesOf(document);
  const joints = new Map((rig.joints ?? []).map((joint) => [joint.id, joint]));
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  const grow = (p) => [0, 1].forEach((i) => {
    low[i] = Math.min(low[i], p[i]);
    high[i] = Math.max(high[i], p[i]);
  });
  for (const {points} of outlines) points.forEach(grow);
  const room = [tileSize - 2 * margin, tileSize - captionHeight - 2 * margin];
  const scale = Math.min(...[0, 1].map((i) => room[i] / Math.max(high[i] - low[i], 1e-9)));
  const put = (p) => [
    tileSize / 2 + (p[0] - (low[0] + high[0]) / 2) * scale,
    captionHeight + margin + room[1] / 2 - (p[1] - (low[1] + high[1]) / 2) * scale,
  ].map((v) => v.toFixed(1));
  const ring = (points) => `M${points.map((p) => put(p).join(' ')).join('L')}Z`;
  const paths = (drawn, style) => drawn.length === 0 ? ''
      : `<path d="${drawn.map(({points}) => ring(points)).join('')}" ${style}/>`;

  const parts = ['<rect width="320" height="320" fill="#fff" stroke="#c8c8c8"/>'];
  parts.push(paths(outlines.filter(({rim}) => !rim), 'fill="#dee2e8"'));
  for (const outline of outlines.filter(({rim}) => rim)) {
    parts.push(paths([outline], 'fill="#dee2e8" fill-opacity=".8" stroke="#8c8c96" stroke-width=".7"'));
  }
  for (const ends of rig.bones ?? []) {
    const [[x1, y1], [x2, y2]] = ends.map((id) => put(joints.get(id).position));
    parts.push(`<path d="M${x1} ${y1}L${x2} ${y2}" stroke="#1e3c8c" stroke-width="2.2"/>`);
  }
  for (const [kind, {radius, color}] of Object.entries(kinds)) {
    for (const joint of joints.values()) {
      if (joint.kind !== kind) continue;
      const [x, y] = put(joint.position);
      parts.push(`<circle cx="${x}" cy="${y}" r="${radius}" fill="${color}"/>`);
    }
  }
  for (const {at, wanted} of crosses) {
    const [x, y] = put(at);
    parts.push(`<path d="M${x} ${y}m-4 -4l8 8m0 -8l-8 8" stroke="${wanted ? '#008c3c' : '#90c8a0'}" ` +
        'stroke-width="1.4"/>');
  }
  const words = [name.slice(0, 34), caption, rig.fault ? 'FAILED' : joints.size].filter(Boolean);
  parts.push(`<text x="5" y="13">${escaped(words.join('  '))}</text>`);
  if (rig.fault) {
    parts.push(`<text x="5" y="${tileSize - 6}" font-size="9" fill="#d83020">${
      escaped(rig.fault.slice(-64))}</text>`);
  }
  return parts.join('\n');
}

function sheet(tiles) {
  const rows = Math.ceil(tiles.length / columns);
  const [width, height] = [columns, rows].map((n) => n * tileSize);
  const placed = tiles.map((svg, i) =>
      `<g transform="translate(${i % columns * tileSize} ${Math.floor(i / columns) * tileSize})">${svg}</g>`);
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" ` +
      'font-family="Inter, sans-serif" font-size="12" fill="#000">' +
      `<rect width="${width}" height="${height}" fill="#fff"/>\n${placed.join('\n')}</svg>\n`;
}

function writePng(svg, file) {
  const done = spawnSync('rsvg-convert', ['-o', file], {input: svg, encoding: 'utf8'});
  if (done.error || done.status !== 0) {
    throw new Error(`rsvg-convert failed: ${done.error?.message ?? done.stderr.trim()}`);
  }
}

async function main(words) {
  const at = words.indexOf('--before');
  const [, before] = at < 0 ? [] : words.splice(at, 2);
  const [program, ...names] = words;
  const out = names.pop();
  if (!out || names.length === 0 || words.some((word) => word.startsWith('--')) ||
      (at >= 0 && !before)) {
    throw new Error('sheets [--before PROGRAM] FILE_OR_FOLDER… OUT_FOLDER');
  }
  const drawings = filesOf(names).map(readDrawing).filter(Boolean);
  const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'marrow-sheets-'));
  const builds = before ? [[before, 'before'], [program, 'after']] : [[program, '']];
  try {
    fs.mkdirSync(out, {recursive: true});
    const tiles = [];
    for (const drawing of drawings) {
      tiles.push(...await Promise.all(builds.map(async ([build, caption], i) =>
          tile(drawing, await rigOf(build, drawing.document, path.join(scratch, String(i))), caption))));
    }
    for (let first = 0, number = 1; first < tiles.length; first += tilesPerSheet, ++number) {
      const file = path.join(out, `sheet-${String(number).padStart(2, '0')}.png`);
      writePng(sheet(tiles.slice(first, first + tilesPerSheet)), file);
      console.log(file);
    }
  } finally {
    fs.rmSync(scratch, {recursive: true, force: true});
  }
}

main(process.argv.slice(2)).catch((error) => {
  console.error(`sheets: ${error.message}`);
  process.exitCode = 1;
});
