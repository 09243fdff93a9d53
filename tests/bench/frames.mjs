// The real frame loop: strokes drawn and parts dragged with the mouse in headless Chromium on
// build/web.
//
// The renderer there is software and would hide everything else, so it is our own code that is
// timed: the pipeline by the app's own clock, and each animation frame's callback as a whole, with
// WebGL's drawing calls left out. The clock has steps of 0.1 ms.
import {readFileSync, readdirSync} from 'node:fs';
import {join} from 'node:path';
import {brotliCompressSync, gzipSync, constants} from 'node:zlib';

import {serve} from '../../scripts/serve.mjs';
import {launch} from '../browser/chromium.mjs';

const width = 1280, height = 800;
const samplesPerFrame = 4;
const median = (list) => [...list].sort((a, b) => a - b)[list.length >> 1];

/// Before the page's own scripts: keeps how long each animation frame's callback took.
function watchFrames() {
  window.frameTimes = [];
  const ask = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (call) => ask((time) => {
    const start = performance.now();
    call(time);
    window.frameTimes.push(performance.now() - start);
  });
}

/// Before the page's own scripts: WebGL takes everything, but draws nothing.
function drawNothing() {
  for (const name of Object.getOwnPropertyNames(WebGL2RenderingContext.prototype)) {
    if (/^(draw(Arrays|Elements|RangeElements)|clear$|blitFramebuffer)/.test(name)) {
      WebGL2RenderingContext.prototype[name] = () => {};
    }
  }
}

/// The stroke in the middle of the canvas, y down.
function onScreen(points) {
  const [xs, ys] = [points.map((p) => p[0]), points.map((p) => p[1])];
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const [low, high] = [Math.min(...ys), Math.max(...ys)];
  const scale = Math.min(560 / (right - left), 560 / (high - low));
  return points.map(([x, y]) => [width / 2 + scale * (x - (left + right) / 2),
                                 height / 2 - scale * (y - (low + high) / 2)]);
}

/// Draws with the mouse; several samples come with each frame, as from a real one.
async function draw({page, session}, stroke) {
  const points = onScreen(stroke.points);
  const move = ([x, y]) => session.send('Input.dispatchMouseEvent', {
    type: 'mouseMoved', x, y, button: 'left', buttons: 1,
  });
  const parts = await page.evaluate(() => window.marrow.parts().length);
  await page.evaluate(() => { window.frameTimes.length = 0; });
  await page.mouse.move(...points[0]);
  await page.mouse.down();
  for (let i = 1; i < points.length; i += samplesPerFrame) {
    await Promise.all(points.slice(i, i + samplesPerFrame).map(move));
  }
  const {preview} = await page.evaluate(() => window.marrow.stats());
  const frames = await page.evaluate(() => window.frameTimes.splice(0));
  await page.mouse.up();
  await page.waitForFunction((n) => window.marrow.parts().length > n, parts, {timeout: 20_000});
  const {part, stats} = await page.evaluate(() => ({part: window.marrow.parts().at(-1),
                                                    stats: window.marrow.stats()}));
  return {
    stroke: stroke.stroke,
    previews: preview.frames,
    previewFirst: preview.firstMs, previewMedian: preview.medianMs, previewMax: preview.maxMs,
    frameMedian: median(frames), frameMax: Math.max(...frames),
    part: part.timings.total, stages: part.timings, vertices: part.mesh.vertices,
    warm: stats.warm.done,
  };
}

async function open(browser, address, {draws = true} = {}) {
  const context = await browser.newContext({viewport: {width, height}});
  const page = await context.newPage();
  await page.addInitScript(watchFrames);
  if (!draws) await page.addInitScript(drawNothing);
  await page.goto(address);
  await page.waitForFunction(() => window.marrow?.ready, null, {timeout: 60_000});
  // Since the navigation: the page's clock starts with it.
  const ready = await page.evaluate(() => window.marrow.ready.then(() => performance.now()));
  return {context, page, session: await context.newCDPSession(page), ready};
}

/// How large the site's parts are over the wire.
function sizes(site) {
  return readdirSync(site).filter((name) => /\.(wasm|js)$/.test(name)).map((name) => {
    const bytes = readFileSync(join(site, name));
    const brotli = brotliCompressSync(bytes, {params: {[constants.BROTLI_PARAM_QUALITY]: 11}});
    return {bench: 'size', file: name, raw: bytes.length, gzip: gzipSync(bytes, {level: 9}).length,
            brotli: brotli.length};
  });
}

/// Takes a part by the mouse where one of its joints is, and moves it about. How long each frame's
/// evaluation took, by the app's own clock.
async function drag({page, session}, document, {steps}) {
  await page.evaluate((text) => window.marrow.load(text), document);
  const frame = () => page.evaluate(() => new Promise((done) =>
      requestAnimationFrame(() => requestAnimationFrame(() => done()))));
  await page.keyboard.press('f');
  await frame();
  await page.waitForFunction(() => !window.marrow.stats().camera.moving);
  await page.keyboard.press('v');
  const {parts, camera, canvas} = await page.evaluate(() => ({
    parts: window.marrow.parts().filter((part) => part.joints),
    camera: window.marrow.stats().camera, canvas: window.marrow.stats().canvas,
  }));
  const places = parts.map(({joints: [{position: [x, y]}]}) => [
    canvas.width / 2 + (x - camera.target[0]) * camera.zoom,
    canvas.height / 2 - (y - camera.target[1]) * camera.zoom]);
  const send = (type, [x, y], buttons) => session.send('Input.dispatchMouseEvent',
      {type, x, y, button: type === 'mouseMoved' && !buttons ? 'none' : 'left', buttons,
       clickCount: 1});
  // One that is not hidden, nor behind a panel.
  let place;
  for (const one of [...places.slice(places.length >> 1), ...places]) {
    await send('mouseMoved', one, 0);
    await send('mousePressed', one, 1);
    await send('mouseReleased', one, 0);
    await frame();
    if (await page.evaluate(() => window.marrow.stats().selection.length === 1)) {
      place = one;
      break;
    }
  }
  if (!place) throw new Error('no part could be taken');
  const before = await page.evaluate(() => JSON.stringify(window.marrow.document()));
  await send('mousePressed', place, 1);
  const times = [];
  for (let i = 1; i <= steps; ++i) {
    const angle = 2 * Math.PI * i / 50;
    await send('mouseMoved', [place[0] + 80 * Math.sin(angle), place[1] + 60 * (1 - Math.cos(angle))],
               1);
    await frame();
    times.push(await page.evaluate(() => window.marrow.stats().evaluation.ms));
  }
  // The circles end where they began: somewhere else, so that there is a change to see.
  await send('mouseMoved', [place[0] + 40, place[1]], 1);
  await send('mouseReleased', [place[0] + 40, place[1]], 0);
  await frame();
  const after = await page.evaluate(() => JSON.stringify(window.marrow.document()));
  if (after === before) throw new Error('no part was dragged');
  times.sort((a, b) => a - b);
  return {bench: 'dragFrames', strokes: parts.length, frames: times.length,
          median: times[times.length >> 1], max: times.at(-1)};
}

/// strokes: [{stroke, points}]; the first is drawn again and again on new pages. character: the
/// text of a document of many parts, to drag one of them.
export async function frames(site, strokes, character, {quick = false} = {}) {
  const rows = sizes(site);
  const server = await serve(site);
  const browser = await launch();
  try {
    for (let i = 0; i < (quick ? 2 : 5); ++i) {
      const tab = await open(browser, server.address);
      const drawn = await draw(tab, strokes[0]);
      rows.push({bench: 'firstStroke', ready: tab.ready, version: browser.version(), ...drawn});
      await tab.context.close();
    }
    const tab = await open(browser, server.address, {draws: false});
    const warm = () => window.marrow.stats().warm.done;
    await tab.page.waitForFunction(warm, null, {timeout: 60_000, polling: 100});
    for (const stroke of strokes) {
      rows.push({bench: 'frames', ...await draw(tab, stroke)});
      await tab.page.evaluate(() => window.marrow.undo());
    }
    if (character) rows.push(await drag(tab, character, {steps: quick ? 60 : 200}));
    await tab.context.close();
  } finally {
    await browser.close();
    await server.close();
  }
  return rows;
}
