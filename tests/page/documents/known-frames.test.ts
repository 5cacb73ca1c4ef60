// What is remembered of files without a unit, whatever else is stored under the key.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import './storage.ts';
import { rememberFrame, rememberedFrame } from '../../../www/documents/known-frames.ts';
import { setItem } from '../../../www/ui/safe-storage.ts';

test('what other code has written there keeps no file from being opened', () => {
  for (const text of ['null', '{}', '[1]', '[["x", null]]', 'words']) {
    setItem('shape-up.frames', text);
    assert.equal(rememberedFrame('a file'), '', text);
    rememberFrame('a file', { units: 'mm', up: 'y' });
    assert.equal(rememberedFrame('a file'), '# units: mm\n# up: y\n');
  }
});
