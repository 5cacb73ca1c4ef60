// What the service worker requests of the site for use without a network.

import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { runInNewContext } from 'node:vm';
import { writeOfflineParts } from '../../../.scripts/offline.mjs';

test('what has a hash in its name is taken from the cache of the browser, all else is asked for', async () => {
  // All of it was asked for again, past that cache.
  const folder = mkdtempSync(join(tmpdir(), 'shape-up-'));
  try {
    mkdirSync(join(folder, 'assets'));
    for (const name of ['index.html', join('assets', 'app-1234567.js')])
      writeFileSync(join(folder, name), '');
    await writeOfflineParts(folder);
    const requests: string[] = [];
    const listeners: Record<string, (event: object) => void> = {};
    let filled: unknown;
    const self = {
      addEventListener: (type: string, listener: () => void) => (listeners[type] = listener),
    };
    const Request = function (name: string, { cache }: { cache: string }) {
      requests.push(`${name} ${cache}`);
    };
    const caches = { open: async () => ({ addAll() {} }) };
    runInNewContext(readFileSync(join(folder, 'service-worker.js'), 'utf8'), {
      ...{ self, Request, caches },
    });
    listeners.install({ waitUntil: (fill: unknown) => (filled = fill) });
    await filled;
    assert.ok(requests.includes('./assets/app-1234567.js default'), `${requests}`);
    assert.ok(requests.includes('./ no-cache'), `${requests}`);
  } finally {
    rmSync(folder, { recursive: true });
  }
});
