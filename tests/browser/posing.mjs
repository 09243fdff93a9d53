// Pose mode, by hand.
import assert from 'node:assert/strict';
import {readFile} from 'node:fs/promises';
import {join} from 'node:path';

import {root} from './harness.mjs';

export const posing = async (app) => (await app.stats()).posing;
export const joint = async (app, name) => {
  const found = (await posing(app)).joints.find((one) => one.name === name);
  assert.ok(found, `there is no joint ${name}`);
  return found;
};
export const poses = (app) => app.page.evaluate(() => marrow.document().poses ?? []);
export const apart = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));
export const ready = (app) => app.until(() => marrow.stats().posing.ready);
export const glidden = (app) => app.page.waitForTimeout(350).then(() => app.settled());

/// A sample of the gallery in pose mode, once its skin fits.
export async function openPosing(app, name, {waits = true} = {}) {
  const text = await readFile(join(root, 'public/samples', `${name}.json`), 'utf8');
  await app.page.evaluate((json) => marrow.load(json), text);
  await app.frames(2);
  await app.key('f');
  await app.key('p');
  if (waits) await ready(app);
  await app.settled();
}

export async function pull(app, name, [dx, dy], options) {
  const [x, y] = (await joint(app, name)).pixel;
  await app.drag([x, y], [x + dx, y + dy], options);
}
