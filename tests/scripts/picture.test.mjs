// The page tests compare pixels, so the decoder is tested with every PNG filter type.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateSync } from 'node:zlib';
import { decodePng, distinctColours } from '../page/picture.ts';

const chunk = (type, data) => {
  const length = Buffer.alloc(4);
  length.writeUInt32BE(data.length);
  // The checksum is not read.
  return Buffer.concat([length, Buffer.from(type, 'latin1'), data, Buffer.alloc(4)]);
};

/** A PNG of RGB rows, each already filtered as its first byte states. */
function png(width, rows) {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(rows.length, 4);
  header.set([8, 2, 0, 0, 0], 8);
  const data = deflateSync(Buffer.from(rows.flat()));
  return Buffer.concat([Buffer.alloc(8), chunk('IHDR', header), chunk('IDAT', data)]);
}

test('all five filters give the same two pixels', () => {
  const plain = [10, 20, 30, 50, 40, 35];
  const picture = decodePng(
    png(2, [
      [0, ...plain],
      [1, 10, 20, 30, 40, 20, 5],
      [2, 0, 0, 0, 0, 0, 0],
      [3, 5, 10, 15, 20, 10, 3],
      [4, 0, 0, 0, 0, 0, 0],
    ]),
  );
  for (let row = 0; row < 5; row++) {
    assert.deepEqual([...picture.pixels.subarray(6 * row, 6 * row + 6)], plain, `filter ${row}`);
  }
  assert.equal(distinctColours(picture), 2);
  assert.equal(distinctColours(picture, { x: 1, width: 1 }), 1);
});
