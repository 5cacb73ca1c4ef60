// The server gives what a browser insists on, from under a sub-path, and nothing from outside.

import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { serve } from '../../.scripts/serve.mjs';

const folder = mkdtempSync(join(tmpdir(), 'shape-up-'));
mkdirSync(join(folder, 'site'));
writeFileSync(join(folder, 'secret.txt'), 'secret');
writeFileSync(join(folder, 'site', 'index.html'), '<p>page</p>');
writeFileSync(join(folder, 'site', 'module.wasm'), 'wasm');
const { address, close } = await serve(join(folder, 'site'), { port: 43170, base: '/sub/' });
after(() => {
  close();
  rmSync(folder, { recursive: true });
});

/** Status, type and body of a path as it is written: `fetch` would resolve the dots itself. */
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

test('the folder is its index.html', async () => {
  const { status, type, body } = await get('/sub/');
  assert.deepEqual([status, type, body], [200, 'text/html; charset=utf-8', '<p>page</p>']);
});

test('wasm has the type that lets it compile while it arrives', async () => {
  assert.equal((await get('/sub/module.wasm')).type, 'application/wasm');
});

test('nothing outside the folder or the base is served', async () => {
  for (const path of ['/', '/sub/../secret.txt', '/sub/..%2fsecret.txt', '/sub/none', '/sub/%zz']) {
    assert.equal((await get(path)).status, 404, path);
  }
});

test('a port that is taken is passed over', async () => {
  const taken = Number(new URL(address).port);
  const second = await serve(join(folder, 'site'), { port: taken });
  assert.ok(Number(new URL(second.address).port) > taken);
  second.close();
});
