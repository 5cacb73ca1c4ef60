// A static host like that of the site: compressed, with validators, so that a second visit is warm.
// It counts the bytes sent.

import { createHash } from 'node:crypto';
import { existsSync, readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { types } from '../serve.mjs';

/** Headers that isolate a page, whose clock then steps by 5 microseconds instead of 100. */
export const isolation = {
  'cross-origin-opener-policy': 'same-origin',
  'cross-origin-embedder-policy': 'require-corp',
};

/** Returns the response for a file. */
function answerOf(path, headers, compress) {
  const contents = readFileSync(path);
  const body = compress ? gzipSync(contents, { level: 9 }) : contents;
  const etag = `"${createHash('sha256').update(body).digest('hex').slice(0, 16)}"`;
  const type = types[extname(path)] ?? 'application/octet-stream';
  const encoding = compress ? { 'content-encoding': 'gzip' } : {};
  const cached = { 'cache-control': 'max-age=600', etag };
  return { body, headers: { 'content-type': type, ...encoding, ...cached, ...headers } };
}

/**
 * Serves folders, each under a path that ends in "/", and pages (texts) under their paths. Resolves
 * with { address, close, takeBytes }.
 */
export function host({ folders, pages = {}, headers = {}, compress = false }) {
  const known = new Map();
  const find = (path) => {
    const mount = Object.keys(folders).find((start) => path.startsWith(start));
    const name = mount && path.slice(mount.length);
    const file = mount && join(folders[mount], name === '' ? 'index.html' : name);
    if (!file || !existsSync(file) || !statSync(file).isFile()) return null;
    if (!known.has(file)) known.set(file, answerOf(file, headers, compress));
    return known.get(file);
  };
  let bytes = 0;
  const server = createServer((request, response) => {
    const path = new URL(request.url, 'http://localhost').pathname;
    if (pages[path]) {
      response.writeHead(200, { 'content-type': types['.html'], ...headers }).end(pages[path]);
      return;
    }
    const found = find(path);
    if (!found) {
      response.writeHead(404).end();
    } else if (request.headers['if-none-match'] === found.headers.etag) {
      response.writeHead(304, found.headers).end();
    } else {
      bytes += found.body.length;
      response.writeHead(200, found.headers).end(found.body);
    }
  });
  return new Promise((done) => {
    server.listen(0, '127.0.0.1', () => {
      done({
        address: `http://127.0.0.1:${server.address().port}/`,
        close: () => server.close(),
        /** Returns the bytes of all response bodies since the last call. */
        takeBytes() {
          const sum = bytes;
          bytes = 0;
          return sum;
        },
      });
    });
  });
}
