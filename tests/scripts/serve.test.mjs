// The local server: the types that browsers require, a base path, what a browser may keep, and no
// files from outside.

import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { serve } from '../../.scripts/serve.mjs';

const folder = mkdtempSync(join(tmpdir(), 'shape-up-'));
mkdirSync(join(folder, 'site', 'assets'), { recursive: true });
writeFileSync(join(folder, 'secret.txt'), 'secret');
writeFileSync(join(folder, 'site', 'index.html'), '<p>page</p>');
writeFileSync(join(folder, 'site', 'module.wasm'), 'wasm');
writeFileSync(join(folder, 'site', 'assets', 'page-1a2b.js'), '1');
const { address, close } = await serve(join(folder, 'site'), { port: 43170, base: '/sub/' });
after(() => {
  close();
  rmSync(folder, { recursive: true });
});

/** The status, type and body of an unnormalised path; `fetch` would resolve the dots itself. */
function get(path) {
  return new Promise((done, reject) => {
    const { hostname, port } = new URL(address);
    request({ hostname, port, path }, async (response) => {
      let body = '';
      for await (const chunk of response) body += chunk;
      done({ status: response.statusCode, type: response.headers['content-type'], body });
    })
      .on('error', reject)
      .end();
  });
}

test('a folder is answered with its index.html', async () => {
  const { status, type, body } = await get('/sub/');
  assert.deepEqual([status, type, body], [200, 'text/html; charset=utf-8', '<p>page</p>']);
});

test('wasm has the type that allows streaming compilation', async () => {
  assert.equal((await get('/sub/module.wasm')).type, 'application/wasm');
});

test('a file is sent again only if it has changed, and one with a hash in its name never', async () => {
  const [module, script] = ['module.wasm', 'assets/page-1a2b.js'];
  const first = await fetch(address + module);
  const again = await fetch(address + module, {
    headers: { 'if-none-match': first.headers.get('etag') },
  });
  assert.deepEqual([first.status, again.status], [200, 304]);
  assert.equal(first.headers.get('cache-control'), 'no-cache');
  assert.match((await fetch(address + script)).headers.get('cache-control'), /immutable/);
  writeFileSync(join(folder, 'site', module), 'another one');
  const changed = await fetch(address + module, {
    headers: { 'if-none-match': first.headers.get('etag') },
  });
  assert.deepEqual([changed.status, await changed.text()], [200, 'another one']);
});

test('nothing outside the folder or the base path is served', async () => {
  for (const path of ['/', '/sub/../secret.txt', '/sub/..%2fsecret.txt', '/sub/none', '/sub/%zz']) {
    assert.equal((await get(path)).status, 404, path);
  }
});

test('a port that is in use is skipped', async () => {
  const taken = Number(new URL(address).port);
  const second = await serve(join(folder, 'site'), { port: taken });
  assert.ok(Number(new URL(second.address).port) > taken);
  second.close();
});
