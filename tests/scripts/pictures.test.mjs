// The pictures of the site: every example has both, and together they are small. That the results
// beside them are of all examples, a native test holds.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { at } from '../../.scripts/project.mjs';

const folder = at('www', 'pictures');
const RESULTS = 'results.json';
const names = readdirSync(folder);
const read = (name) => readFileSync(join(folder, name));

/** Width and height of a WebP picture with transparency. */
function sizeOf(picture) {
  const text = (from, to) => picture.toString('latin1', from, to);
  assert.equal(text(0, 4) + text(8, 16), 'RIFFWEBPVP8X');
  return [24, 27].map((from) => picture.readUIntLE(from, 3) + 1);
}

test('every example has a picture of its start and of its end, and there are no others', () => {
  const ids = JSON.parse(read(RESULTS)).map(({ id }) => id);
  assert.ok(ids.length > 30);
  const ofExamples = ids.flatMap((id) => ['start', 'end'].map((when) => `${id}-${when}.webp`));
  const ofFirst = ['wide', 'narrow'].flatMap((window) =>
    ['light', 'dark'].map((theme) => `first-${window}-${theme}.webp`),
  );
  assert.deepEqual([...names].sort(), [...ofExamples, ...ofFirst, RESULTS].sort());
  for (const name of ofExamples) assert.deepEqual(sizeOf(read(name)), [378, 273], name);
  const html = readFileSync(at('www', 'index.html'), 'utf8');
  for (const name of ofFirst) {
    const [width, height] = sizeOf(read(name));
    const shown = html.match(new RegExp(`${name}"[^>]*width="(\\d+)"\\s+height="(\\d+)"`));
    assert.ok(shown, name);
    // The proportions that the page reserves.
    assert.ok(Math.abs((width / height / shown[1]) * shown[2] - 1) < 0.005, name);
  }
});

test('together the pictures have at most 1 MB', () => {
  const bytes = names.reduce((sum, name) => sum + read(name).length, 0);
  assert.ok(bytes < 1e6, `${bytes} bytes`);
});
