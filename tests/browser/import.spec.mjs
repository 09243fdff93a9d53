// 3D models from elsewhere: dropped on the canvas or opened, they become parts.
import assert from 'node:assert/strict';

import {circle, closed, dense, isBody, test} from './harness.mjs';

/// A limb that bends to the right and to the viewer: vertices and triangles.
function limb(around = 16, along = 30) {
  const points = [], triangles = [];
  for (let i = 0; i <= along; ++i) {
    const t = i / along, radius = 1.6 - t;
    for (let j = 0; j < around; ++j) {
      const angle = 2 * Math.PI * j / around;
      points.push([3 * t * t + radius * Math.cos(angle), 10 * t,
                   4 * t * t + radius * Math.sin(angle)]);
    }
  }
  const at = (i, j) => i * around + j % around;
  for (let i = 0; i < along; ++i) {
    for (let j = 0; j < around; ++j) {
      triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)],
                     [at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  }
  return {points, triangles};
}

/// Binary STL, with z up; the ends are open, as many a scan is.
function stl({points, triangles}) {
  const bytes = Buffer.alloc(84 + 50 * triangles.length);
  bytes.writeUInt32LE(triangles.length, 80);
  triangles.forEach((corners, t) => corners.forEach((corner, k) => {
    const [x, y, z] = points[corner];
    [x, -z, y].forEach((number, axis) =>
        bytes.writeFloatLE(number, 84 + 50 * t + 12 + 12 * k + 4 * axis));
  }));
  return bytes;
}

const obj = ({points, triangles}) => Buffer.from(points.map((p) => `v ${p.join(' ')}\n`).join('') +
    triangles.map((t) => `f ${t.map((i) => i + 1).join(' ')}\n`).join(''));

/// A GLB with nothing in it but a drawing, as Marrow keeps it there.
function glbOf(document) {
  const binary = Buffer.concat([document, Buffer.alloc((4 - document.length % 4) % 4)]);
  let text = JSON.stringify({
    asset: {version: '2.0', extras: {marrow: {version: 1, document: 0}}},
    buffers: [{byteLength: binary.length}],
    bufferViews: [{buffer: 0, byteLength: document.length}],
  });
  text = text.padEnd(Math.ceil(text.length / 4) * 4);
  const words = (...numbers) => Buffer.from(Uint32Array.from(numbers).buffer);
  return Buffer.concat([
    Buffer.from('glTF'), words(2, 28 + text.length + binary.length, text.length, 0x4E4F534A),
    Buffer.from(text), words(binary.length, 0x004E4942), binary]);
}

function dropped(app, name, bytes) {
  return app.page.evaluate(({file, base64}) => {
    const transfer = new DataTransfer();
    const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    transfer.items.add(new File([data], file));
    document.getElementById('canvas').dispatchEvent(
        new DragEvent('drop', {bubbles: true, cancelable: true, dataTransfer: transfer}));
  }, {file: name, base64: bytes.toString('base64')});
}
const grown = (app, parts) =>
    app.until((n) => marrow.parts().length === n, parts).then(() => app.settled());

test('a dropped STL becomes a part with a skeleton at the middle of its depth', async (app) => {
  const {width, height} = app.page.viewportSize();
  await dropped(app, 'my limb.stl', stl(limb()));
  await grown(app, 1);
  await app.screenshot('limb');
  const [part] = await app.parts();
  assert.equal(part.name, 'my limb');
  assert.ok(part.joints.length >= 3);
  const depths = part.joints.map((joint) => joint.position[2]);
  assert.ok(Math.max(...depths) - Math.min(...depths) > 40, `it bends to the viewer: ${depths}`);
  assert.equal((await app.stats()).selected, part.id);
  const seen = (await app.pixels()).find(isBody, [300, 0, width - 320, height]);
  assert.ok(Math.abs((seen.bottom - seen.top) / height - 0.5) < 0.03, 'half as high as the view');
  assert.ok(Math.abs((seen.bottom + seen.top) / 2 - height / 2) < 0.03 * height, 'in the middle');

  await app.key('Control+z');
  assert.equal((await app.parts()).length, 0);
  await app.key('Control+Shift+z');
  assert.equal((await app.parts()).length, 1);

  // It is kept with the drawing, bit for bit.
  const text = await app.document();
  await app.page.evaluate((json) => marrow.load(json), text);
  assert.equal(await app.document(), text);

  // What is drawn over it hangs on it.
  await app.click(60, 700);
  await app.draw(dense(closed(circle(width / 2, height * 0.72, 90)), 10));
  const rig = await app.page.evaluate(() => marrow.rig());
  assert.equal(rig.roots.length, 1);
  await app.key('3');
  await app.settled();
  await app.screenshot('limb-from-the-right');
});

test('an OBJ comes as the view shows it; its outline is not to be drawn over', async (app) => {
  await app.key('3');
  await app.settled();
  await dropped(app, 'limb.obj', obj(limb()));
  await grown(app, 1);
  const {frame} = JSON.parse(await app.document()).parts[0];
  assert.ok(Math.abs(frame.x[2] + 1) < 1e-9, 'in the plane of the right view');
  const before = await app.document();
  const {width, height} = app.page.viewportSize();
  await app.key('c');
  await app.draw(dense([[width / 2 - 150, height / 2], [width / 2 + 150, height / 2 + 30]], 10));
  assert.equal(await app.document(), before);
});

test('what cannot be closed is refused with the reason', async (app) => {
  const torn = limb();
  torn.triangles = torn.triangles.filter((corners) => torn.points[corners[0]][2] > -0.2);
  const cases = {
    'torn.stl': [stl(torn), /hole/], 'empty.obj': [Buffer.from(''), /no surface/],
    'short.stl': [stl(limb()).subarray(0, 3000), /middle of a triangle/],
    'text.ply': [Buffer.from('ply\nhello'), /header/], 'bad.glb': [Buffer.from('glTFxxxx'), /GLB/],
  };
  for (const [name, [bytes, reason]] of Object.entries(cases)) {
    await dropped(app, name, bytes);
    await app.until((file) => marrow.stats().message?.startsWith(file), name);
    const {message} = await app.stats();
    assert.match(message, /^\S+ cannot be imported: \S.{6,120}\.$/, name);
    assert.match(message, reason);
    assert.equal((await app.parts()).length, 0);
  }
  await app.screenshot('refused');
});

test('a GLB that Marrow wrote opens as its drawing', async (app) => {
  const document = Buffer.from(JSON.stringify({format: 'marrow', version: 1, parts: [
    {name: 'Größe', stroke: {points: [[0, 0], [100, 0], [100, 100], [0, 100]]}}]}));
  await dropped(app, 'creature.glb', glbOf(document));
  await grown(app, 1);
  assert.equal(await app.page.title(), 'creature – Marrow');
  await app.key('Control+z');
  assert.equal((await app.parts()).length, 0);
});
