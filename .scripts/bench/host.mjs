// A static host like that of the site: compressed, with validators, so that a second visit is warm.
// It counts the bytes sent.

import { createHash } from 'node:crypto';
import { existsSync, readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { types } from '../serve.mjs';

/** Returns the response for a file. */
function answerOf(path, headers) {
  const body = gzipSync(readFileSync(path), { level: 9 });
  const etag = `"${createHash('sha256').update(body).digest('hex').slice(0, 16)}"`;
  const type = types[extname(path)] ?? 'application/octet-stream';
  const encoding = { 'content-type': type, 'content-encoding': 'gzip' };
  return { body, headers: { ...encoding, 'cache-control': 'max-age=600', etag, ...headers } };
}

/**
 * Serves folders, each under a path that ends in "/". Resolves with { address, close, takeBytes }.
 */
export async function host({ folders, headers = {} }) {
  const known = new Map();
  const find = (path) => {
    const mount = Object.keys(folders).find((start) => path.startsWith(start));
    const file = mount && join(folders[mount], path.slice(mount.length) || 'index.html');
    if (!file || !existsSync(file) || !statSync(file).isFile()) return null;
    if (!known.has(file)) known.set(file, answerOf(file, headers));
    return known.get(file);
  };
  let bytes = 0;
  const server = createServer((request, response) => {
    const found = find(new URL(request.url, 'http://localhost').pathname);
    if (!found) {
      response.writeHead(404, headers).end();
    } else if (request.headers['if-none-match'] === found.headers.etag) {
      response.writeHead(304, found.headers).end();
    } else {
      bytes += found.body.length;
      response.writeHead(200, found.headers).end(found.body);
    }
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  return {
    address: `http://127.0.0.1:${server.address().port}/`,
    close: () => server.close(),
    /** Returns the bytes of all response bodies since the last call. */
    takeBytes() {
      const sum = bytes;
      bytes = 0;
      return sum;
    },
  };
}
