// What a link unpacks to, and where that ends.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateRawSync } from 'node:zlib';
import { MOST_BYTES, readLink, unpack, writeLink } from '../../../www/documents/share-link.js';

const code = (bytes) => deflateRawSync(bytes).toString('base64url');

test('a scene comes out of its link as it went in', async () => {
  const text = JSON.stringify({ format: 'shape-up-scene', title: 'Dach ✓', many: 'x'.repeat(3e6) });
  const link = readLink(await writeLink(text, undefined, null, true));
  assert.equal(await unpack(link.code), text);
  assert.equal(link.run, true);
});

test('a link that was cut is refused', async () => {
  const whole = code(Buffer.from('a scene with some words '.repeat(999)));
  await assert.rejects(unpack(whole.slice(0, -9)), /incomplete or damaged/);
  await assert.rejects(unpack('!'), /incomplete or damaged/);
});

test('a link that unpacks to more than a scene can be is refused, and the page has its turns', async () => {
  const bomb = code(Buffer.alloc(MOST_BYTES * 2));
  let turns = 0;
  const timer = setInterval(() => (turns += 1), 1);
  await assert.rejects(unpack(bomb), /more than 32 MB/);
  clearInterval(timer);
  assert.ok(turns >= 10, `${turns} turns while it was unpacked`);
});
