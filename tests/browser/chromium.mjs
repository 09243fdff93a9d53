// The browser that specs and benchmarks run in: headless, with WebGL 2 in software.
import {existsSync} from 'node:fs';
import {createRequire} from 'node:module';

const {chromium} = createRequire(import.meta.url)('playwright-core');

const browsers = [process.env.CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser',
                  '/usr/bin/google-chrome'];

export async function launch() {
  const executablePath = browsers.find((path) => path && existsSync(path));
  if (!executablePath) {
    throw new Error('Chromium is missing. Install it: apt-get install chromium, or set CHROMIUM.');
  }
  return chromium.launch({
    executablePath,
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader',
           '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run',
           '--disable-background-networking', '--disable-component-update', '--disable-sync'],
  });
}
