// node tests/browser/run.mjs [SPEC.mjs…]: runs browser specs, all of them without an argument, in
// headless Chromium against build/web. ONLY: a part of the names of the tests to run. SITE: the
// folder of another build. SMOOTH: with smooth edges, to look at the screenshots.
import {existsSync, readdirSync} from 'node:fs';
import {basename, join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

import {serve} from '../../scripts/serve.mjs';
import {launch} from './chromium.mjs';
import {App, registered, root} from './harness.mjs';

/// Smooth edges cost a quarter of the time where rendering is software, and are for the eye alone.
function withoutSmoothing() {
  const {getContext} = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function(kind, options) {
    const plain = kind === 'webgl2' ? {...options, antialias: false} : options;
    return getContext.call(this, kind, plain);
  };
}

async function runTest(browser, address, label, {options, run}) {
  const {width = 1280, height = 800, scale = 1, touch = false} = options;
  const context = await browser.newContext({
    viewport: {width, height}, deviceScaleFactor: scale, hasTouch: touch, isMobile: false,
  });
  let timer;
  try {
    const page = await context.newPage();
    const app = new App(page, await context.newCDPSession(page), address, label);
    if (!process.env.SMOOTH && !options.smooth) await page.addInitScript(withoutSmoothing);
    if (options.init) await page.addInitScript(options.init);
    if (options.prepare) await options.prepare(app);
    const late = new Promise((_, fail) => {
      timer = setTimeout(() => fail(new Error('took longer than 120 s')), 120_000);
    });
    await Promise.race([late, app.open(options).then(() => run(app))]);
    if (app.errors.length) throw new Error(`the page logged:\n${app.errors.join('\n')}`);
  } finally {
    clearTimeout(timer);
    await context.close();
  }
}

async function main() {
  const site = process.env.SITE ?? join(root, 'build/web');
  if (!existsSync(join(site, 'index.html'))) {
    throw new Error(`${site} is not there: scripts/test builds it.`);
  }
  const folder = join(root, 'tests/browser');
  const specs = process.argv.length > 2
      ? process.argv.slice(2).map((path) => resolve(path))
      : readdirSync(folder).filter((name) => name.endsWith('.spec.mjs')).sort()
            .map((name) => join(folder, name));
  const server = await serve(site);
  const browser = await launch();
  const count = {passed: 0, failed: 0};
  try {
    for (const spec of specs) {
      registered.length = 0;
      await import(pathToFileURL(spec));
      const label = basename(spec, '.spec.mjs');
      for (const test of registered.filter(({name}) => name.includes(process.env.ONLY ?? ''))) {
        const start = Date.now();
        try {
          await runTest(browser, server.address, label, test);
          ++count.passed;
          console.log(`ok      ${label}: ${test.name} (${Date.now() - start} ms)`);
        } catch (error) {
          ++count.failed;
          console.log(`FAILED  ${label}: ${test.name}\n${error.stack ?? error}`);
        }
      }
    }
  } finally {
    await browser.close();
    await server.close();
  }
  console.log(`${count.passed} passed, ${count.failed} failed`);
  if (count.failed || !count.passed) process.exitCode = 1;
}

main().catch((error) => {
  console.error(error.message);
  process.exitCode = 1;
});
