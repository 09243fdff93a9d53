// node scripts/serve.mjs [FOLDER]: serves a static site and prints its address. PORT chooses the
// port (without it, 8000 or the next free one), HOST the interface (localhost only by default).
import {createReadStream} from 'node:fs';
import {stat} from 'node:fs/promises';
import {createServer} from 'node:http';
import {extname, join, normalize, resolve, sep} from 'node:path';
import {fileURLToPath} from 'node:url';

const types = {
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.ico': 'image/x-icon',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.map': 'application/json; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain; charset=utf-8',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
};

/// The file for a request's path, or null; never one outside of `root`.
async function find(root, url) {
  let path;
  try {
    path = decodeURIComponent(new URL(url, 'http://localhost').pathname);
  } catch {
    return null;
  }
  const file = normalize(join(root, path.endsWith('/') ? path + 'index.html' : path));
  if (path.includes('\0') || !file.startsWith(root + sep)) return null;
  const info = await stat(file).catch(() => null);
  return info?.isFile() ? {file, info} : null;
}

/// Serves `folder`; port 0 takes any free one. Resolves to {address, port, close()}.
export function serve(folder, {port = 0, host = '127.0.0.1'} = {}) {
  const root = resolve(folder);
  const server = createServer(async (request, response) => {
    if (request.method !== 'GET' && request.method !== 'HEAD') {
      response.writeHead(405, {Allow: 'GET, HEAD'}).end();
      return;
    }
    const found = await find(root, request.url);
    if (!found) {
      response.writeHead(404, {'Content-Type': 'text/plain'}).end('There is nothing here.\n');
      return;
    }
    // Browsers may keep a file, but ask each time whether it is still the same.
    const tag = `"${found.info.size.toString(16)}-${found.info.mtimeMs.toString(16)}"`;
    const headers = {'Cache-Control': 'no-cache', ETag: tag};
    if (request.headers['if-none-match'] === tag) {
      response.writeHead(304, headers).end();
      return;
    }
    headers['Content-Type'] = types[extname(found.file)] ?? 'application/octet-stream';
    headers['Content-Length'] = found.info.size;
    response.writeHead(200, headers);
    if (request.method === 'HEAD') {
      response.end();
    } else {
      createReadStream(found.file).on('error', () => response.destroy()).pipe(response);
    }
  });
  return new Promise((done, fail) => {
    server.once('error', fail);
    server.listen(port, host, () => {
      const actual = server.address().port;
      const name = host === '127.0.0.1' ? 'localhost' : host;
      const close = () => new Promise((closed) => {
        server.close(closed);
        server.closeAllConnections?.();
      });
      done({address: `http://${name}:${actual}/`, port: actual, close});
    });
  });
}

async function main() {
  const folder = process.argv[2] ?? 'build/web';
  const host = process.env.HOST ?? '127.0.0.1';
  const chosen = process.env.PORT;
  if (chosen !== undefined && !/^\d{1,5}$/.test(chosen)) {
    console.error(`PORT is not a number: ${chosen}`);
    process.exit(1);
  }
  const candidates = chosen ? [Number(chosen)] : [8000, 8001, 8002, 8003, 8004, 0];
  for (const port of candidates) {
    try {
      const {address} = await serve(folder, {port, host});
      console.log(`Marrow is at ${address}   (Ctrl C ends it)`);
      return;
    } catch (error) {
      if (error.code === 'EADDRINUSE' && port !== candidates.at(-1)) continue;
      console.error(error.code === 'EADDRINUSE' ? `Port ${port} is taken; choose another with PORT.`
                                                : error.message);
      process.exit(1);
    }
  }
}

if (process.argv[1] && resolve(process.argv[1]) === fileURLToPath(import.meta.url)) await main();
