// A local server of static files: dist/ for `npm start` and for the page tests. A browser keeps what
// it has fetched: the files of the bundler have new names with new content, the others are asked for
// again, and sent only if they have changed.
// As a program: node .scripts/serve.mjs [PORT] [BASE], where BASE is the path prefix of the site.

import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { at } from './project.mjs';
import { main, Problem } from './run.mjs';

const host = '127.0.0.1';

// Browsers reject .wasm files and modules of any other type.
const types = {
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.map': 'application/json; charset=utf-8',
  '.obj': 'model/obj',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
  '.webp': 'image/webp',
  '.webmanifest': 'application/manifest+json',
};

/** The bundler's files, whose names contain a hash of their content. */
const isHashed = (folder, file) => file.startsWith(join(folder, 'assets') + sep);

/** Returns the file of a request and its version, or null. */
function fileOf(folder, base, url) {
  try {
    const path = decodeURIComponent(new URL(url, 'http://localhost').pathname);
    if (!path.startsWith(base)) return null;
    const file = join(folder, path.slice(base.length), path.endsWith('/') ? 'index.html' : '');
    const { size, mtimeMs } = statSync(file);
    const isInside = file.startsWith(folder + sep) && statSync(file).isFile();
    return isInside ? { file, version: `"${size}-${mtimeMs}"` } : null;
  } catch {
    return null;
  }
}

/**
 * Serves `folder`, resolves with { address, close }. If the port is taken, tries the next ones.
 * `extra` headers are sent with every file, whose content is what `read` streams.
 */
export function serve(folder, { port, base = '/', extra = {}, read = createReadStream }) {
  const server = createServer((request, response) => {
    const found = fileOf(folder, base, request.url);
    if (!found) {
      response.writeHead(404, { 'content-type': 'text/plain' }).end('Not found\n');
      return;
    }
    const { file, version } = found;
    const type = types[extname(file)] ?? 'application/octet-stream';
    const kept = isHashed(folder, file) ? 'max-age=31536000, immutable' : 'no-cache';
    const headers = { 'content-type': type, 'cache-control': kept, etag: version, ...extra };
    if (request.headers['if-none-match'] === version) {
      response.writeHead(304, headers).end();
      return;
    }
    response.writeHead(200, headers);
    read(file).pipe(response);
  });
  return new Promise((done, reject) => {
    let next = port;
    server.on('error', (error) => {
      if (error.code === 'EADDRINUSE' && next < port + 100) server.listen(++next, host);
      else reject(new Problem(`Cannot serve on ${host}:${next}: ${error.message}`));
    });
    server.on('listening', () => {
      const address = `http://${host}:${server.address().port}${base}`;
      done({ address, close: () => server.close() });
    });
    server.listen(next, host);
  });
}

/** Resolves with a port that nobody listens at. */
export async function freePort() {
  const { address, close } = await serve(at('dist'), { port: 0 });
  close();
  return Number(new URL(address).port);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [port = '4173', base = '/'] = process.argv.slice(2);
  await main(async () => {
    const { address } = await serve(at('dist'), { port: Number(port), base });
    console.log(address);
  });
}
