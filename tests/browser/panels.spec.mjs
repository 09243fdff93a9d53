// Panels and the canvas: what lies where, what is seen beside a panel, and what stays closed.
import assert from 'node:assert/strict';

import {circle, closed, dense, differing, isBody, test} from './harness.mjs';

const ring = (x, y, radius) => dense(closed(circle(x, y, radius)), 10);
const phone = {width: 360, height: 740, touch: true};

const tap = async (app, panel, id, index) => {
  const {x, y} = await app.widget(panel, id, index);
  await app.touch([[[x, y]]]);
};
const panels = async (app) => new Set((await app.stats()).widgets.map(({panel}) => panel));
const camera = async (app) => (await app.stats()).camera;
const load = (app, parts) =>
    app.page.evaluate((all) => marrow.load({format: 'marrow', version: 1, parts: all}), parts)
        .then(() => app.settled());
const stroke = {points: circle(0, 0, 100)};

/// Every control lies on the canvas, and none upon one of another panel.
async function inOrder(app, what) {
  const {widgets, canvas} = await app.stats();
  for (const {panel, id, x, y, width, height} of widgets) {
    assert.ok(x >= 0 && y >= 0 && x + width <= canvas.width && y + height <= canvas.height,
              `${what}: ${panel}/${id} is cut off`);
  }
  for (const a of widgets) {
    for (const b of widgets) {
      const meet = a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
          b.y < a.y + a.height;
      assert.ok(a.panel === b.panel || !meet, `${what}: ${a.panel}/${a.id} meets ${b.panel}/${b.id}`);
    }
  }
}

for (const [width, height] of [[740, 360], [640, 360], [844, 390]]) {
  test(`a phone held across, ${width} × ${height}`, {width, height, scale: 2, touch: true},
       async (app) => {
    await app.until(() => marrow.stats().widgets.some(({id}) => id === 'samples'));
    await inOrder(app, 'the invitation');
    await app.screenshot(`across-${width}-hint`);
    await app.touch([ring(width / 2 - 40, 190, 70)]);
    await inOrder(app, 'drawn');
    for (const sheet of ['part', 'parts', 'view', 'help']) {
      await tap(app, 'lower bar', sheet);
      await inOrder(app, sheet);
      await app.screenshot(`across-${width}-${sheet}`);
      if (sheet === 'part') {
        const rows = (await app.stats()).widgets.filter(({panel}) => panel === 'part');
        assert.ok(rows.length >= 8, `${rows.length} controls are seen`);
      }
      await tap(app, 'lower bar', sheet);
    }
  });
}

test('everything is shown beside the panels', async (app) => {
  await app.draw(dense([[300, 350], [700, 350], [700, 450], [300, 450], [300, 350]], 10));
  const {widgets} = await app.stats();
  const panel = Math.min(...widgets.filter((one) => one.panel === 'part').map(({x}) => x)) - 16;
  await app.key('f');
  const beside = (await app.pixels()).find(isBody, [70, 70, panel, 735]);
  assert.ok(beside.right < panel - 4, `${beside.right} is left of ${panel}`);
  assert.ok(beside.right - beside.left > 700, 'and still large');
  await app.press('switches', 'parts');
  await app.key('f');
  await app.screenshot('framed');
  const list = Math.max(...(await app.stats()).widgets.filter((one) => one.panel === 'parts')
      .map(({x, width}) => x + width));
  const between = (await app.pixels()).find(isBody, [list + 20, 70, panel, 735]);
  assert.ok(between.left > list + 8 && between.right < panel - 4);
  await app.key('Escape');
  await app.key('Escape');
  await app.key('f');
  const {left, right} = (await app.pixels()).find(isBody, [70, 180, 1250, 735]);
  assert.ok(Math.abs((left + right) / 2 - 640) < 4, 'in the middle where nothing is open');
});

test('a sheet of a phone does not cover the model that it changes', phone, async (app) => {
  await app.touch([ring(180, 400, 120)]);
  const before = await camera(app);
  for (const sheet of ['part', 'parts']) {
    await tap(app, 'lower bar', sheet);
    await app.screenshot(`room-${sheet}`);
    const {widgets} = await app.stats();
    const top = Math.min(...widgets.filter(({panel}) => panel === sheet).map(({y}) => y)) - 14;
    const seen = (await app.pixels()).find(isBody, [0, 62, 280, top]);
    assert.ok(seen.bottom < top - 4 && seen.top > 62, `${sheet}: ${JSON.stringify(seen)}`);
    assert.ok(seen.right - seen.left > 90, `${sheet}: large enough`);
    await tap(app, 'lower bar', sheet);
    assert.deepEqual(await camera(app), before, 'it comes back');
  }
  // Unless the user looks elsewhere meanwhile.
  await tap(app, 'lower bar', 'part');
  await app.touch([dense([[150, 200], [130, 200]], 4), dense([[200, 200], [230, 200]], 6)]);
  const own = await camera(app);
  await tap(app, 'lower bar', 'part');
  assert.deepEqual(await camera(app), own);
  // What is beside the sheet already stays where it is.
  await tap(app, 'toolbar', 'frame');
  await tap(app, 'lower bar', 'part');
  await tap(app, 'toolbar', 'frame');
  const framed = await camera(app);
  await tap(app, 'part', 'skeleton');
  await tap(app, 'part', 'hide');
  assert.equal((await camera(app)).yaw, framed.yaw);
});

test('a file is saved under the name that is being typed', {init: () => {
  delete window.showSaveFilePicker;
}}, async (app) => {
  await app.draw(ring(500, 350, 120));
  await app.press('toolbar', 'file');
  const {x, y} = await app.widget('file', 'name');
  await app.click(x, y);
  const [download] = await Promise.all([app.page.waitForEvent('download'), (async () => {
    await app.page.keyboard.type('Giraffe');
    await app.page.keyboard.press('Control+s');
  })()]);
  assert.equal(download.suggestedFilename(), 'Giraffe.json');
  await app.settled();
  assert.equal(await app.page.title(), 'Giraffe – Marrow');
});

test('letters and a click beside them in one frame: all letters are kept', async (app) => {
  await app.draw(ring(500, 350, 120));
  const {x, y} = await app.widget('part', 'name');
  await app.click(x, y);
  await app.until(() => document.activeElement.tagName === 'INPUT');
  await app.page.evaluate(() => {
    const field = document.activeElement;
    field.value = 'Elephant';
    field.dispatchEvent(new Event('input'));
    const at = {pointerId: 1, pointerType: 'mouse', clientX: 300, clientY: 650, button: 0};
    const canvas = document.getElementById('canvas');
    canvas.dispatchEvent(new PointerEvent('pointerdown', {...at, buttons: 1}));
    canvas.dispatchEvent(new PointerEvent('pointerup', at));
  });
  await app.frames(6);
  await app.settled();
  assert.equal(await app.page.evaluate(() => marrow.document().parts[0].name), 'Elephant');
  await app.key('v');
  assert.equal((await app.stats()).tool, 'select', 'letters are keys again');
});

test('a click on the canvas takes the keyboard from a name, however short it is', async (app) => {
  await app.draw(ring(500, 350, 120));
  await app.press('toolbar', 'file');
  const {x, y} = await app.widget('file', 'name');
  await app.click(x, y);
  await app.until(() => document.activeElement.tagName === 'INPUT');
  await app.page.evaluate(() => {
    const at = {pointerId: 1, pointerType: 'mouse', clientX: 700, clientY: 650, button: 0};
    const canvas = document.getElementById('canvas');
    canvas.dispatchEvent(new PointerEvent('pointerdown', {...at, buttons: 1}));
    canvas.dispatchEvent(new PointerEvent('pointerup', at));
  });
  await app.settled();
  await app.key('v');
  assert.equal((await app.stats()).tool, 'select');
});

test('no panel opens by itself when the part is let go', async (app) => {
  await app.draw(ring(500, 350, 120));
  await app.press('part', 'skeleton');
  assert.ok((await app.stats()).widgets.some(({id}) => id === 'simplify'));
  await app.key('Escape');
  assert.ok(!(await panels(app)).has('refine'), 'Esc');
  await app.click(500, 300);
  await app.press('part', 'close');
  assert.ok(!(await panels(app)).has('refine'), 'its own button');
  await app.click(500, 300);
  await app.click(300, 650);
  assert.ok(!(await panels(app)).has('refine'), 'a click beside');

  // The button below opens them where they are seen, and closes them again.
  await app.press('switches', 'skeleton');
  assert.ok((await panels(app)).has('refine'));
  await app.click(500, 300);
  assert.ok((await app.stats()).widgets.some(({panel, id}) => panel === 'part' && id === 'simplify'));
  await app.press('switches', 'skeleton');
  assert.ok(!(await app.stats()).widgets.some(({id}) => id === 'simplify'));
  await app.press('switches', 'skeleton');
  assert.ok((await app.stats()).widgets.some(({panel, id}) => panel === 'part' && id === 'simplify'));
});

test('names in Greek and Cyrillic letters can be read', {scale: 2}, async (app) => {
  const picture = async (name) => {
    await load(app, [{name, stroke}]);
    await app.click(640, 330);
    await app.page.mouse.move(300, 500);
    await app.settled();
    await app.screenshot(`name-${name.length}`);
    return app.pixels();
  };
  const unknown = await picture('\u4e00\u4e00\u4e00\u4e00');
  for (const name of ['Лапа', 'Πόδι', 'Ґава', 'țară']) {
    assert.ok(differing(unknown, await picture(name)) > 100, name);
  }
});

test('a double click on a slider is one step', async (app) => {
  await app.draw(ring(500, 350, 120));
  await app.draw(ring(560, 250, 60));
  for (const id of ['thickness', 'depth']) {
    const {x, y, width} = await app.widget('part', id);
    const before = await app.document();
    await app.page.mouse.click(x + width / 4, y);
    await app.settled();
    await app.page.mouse.click(x - width / 4, y);
    await app.settled();
    const moved = await app.document();
    assert.notEqual(moved, before);
    await app.page.waitForTimeout(800);
    await app.page.mouse.click(x + width / 4, y, {clickCount: 2});
    await app.settled();
    const reset = await app.document();
    assert.notEqual(reset, moved, id);
    await app.key('Control+z');
    assert.equal(await app.document(), moved, `${id}: one step`);
    await app.key('Control+Shift+z');
    assert.equal(await app.document(), reset);
  }
  assert.equal(await app.page.evaluate(() => marrow.document().parts[1].thickness), 1);
});

test('a colour that came with a file is among those to choose from', async (app) => {
  await load(app, [{color: '#123456', stroke}]);
  const swatches = async () => (await app.stats()).widgets.filter(({id}) => id === 'color').length;
  await app.click(640, 330);
  assert.equal(await swatches(), 8);
  await app.screenshot('own-colour');
  await app.press('part', 'color', 2);
  assert.equal(await swatches(), 7);
});

for (const [height, both] of [[1180, true], [700, false]]) {
  test(`on a tablet what the last stroke took lies upon no other panel, ${height} high`,
       {width: 820, height, touch: true}, async (app) => {
    await app.touch([ring(300, 400, 120)]);
    const open = async () => {
      const all = await panels(app);
      return [all.has('help panel'), all.has('performance panel')];
    };
    await tap(app, 'toolbar', 'help');
    await tap(app, 'performance button', 'performance');
    await app.screenshot(`tablet-${height}`);
    await inOrder(app, 'with help before');
    assert.deepEqual(await open(), [both, true], 'the newer one stays');
    if (both) await tap(app, 'toolbar', 'help');
    await tap(app, 'toolbar', 'help');
    await inOrder(app, 'with help after');
    assert.deepEqual(await open(), [true, both], 'the newer one stays');
  });
}

test('a long name ends in dots', async (app) => {
  await load(app, [{name: 'The left hind leg of the old giraffe with the long neck', stroke}]);
  await app.click(640, 330);
  await app.screenshot('long-name');
});
