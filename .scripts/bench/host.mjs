// A static host like that of the site: compressed, with validators, so that a second visit is warm.

import { once } from 'node:events';
import { readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { types } from '../serve.mjs';

/** Serves a folder; resolves with { address, close, sent }: the bytes of all bodies so far. */
export async function host(folder, headers = {}) {
  /** Bodies by file: compressed once, so that no visit waits for it. */
  const bodies = new Map();
  let bytes = 0;
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url, 'http://localhost');
    const file = join(folder, pathname, pathname.endsWith('/') ? 'index.html' : '');
    const found = statSync(file, { throwIfNoEntry: false });
    if (!found?.isFile()) return response.writeHead(404, headers).end();
    const etag = `"${found.size}-${found.mtimeMs}"`;
    const type = types[extname(file)] ?? 'application/octet-stream';
    const kept = { 'cache-control': 'max-age=600', etag, ...headers };
    if (request.headers['if-none-match'] === etag) return response.writeHead(304, kept).end();
    if (!bodies.has(file)) bodies.set(file, gzipSync(readFileSync(file), { level: 9 }));
    bytes += bodies.get(file).length;
    response.writeHead(200, { 'content-type': type, 'content-encoding': 'gzip', ...kept });
    return response.end(bodies.get(file));
  });
  server.listen(0, '127.0.0.1');
  await once(server, 'listening');
  const address = `http://127.0.0.1:${server.address().port}/`;
  return { address, close: () => server.close(), sent: () => bytes };
}
