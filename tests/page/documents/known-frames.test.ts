// What is remembered of files without a unit, whatever else is stored under the key.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import './storage.ts';
import { rememberFrame, rememberedFrame } from '../../../www/documents/known-frames.ts';
import { frameOf } from '../../../www/store/frame.ts';
import { setItem } from '../../../www/ui/safe-storage.ts';
import type { Document as SceneDocument } from '../../../www/pkg/engine/shape_up.js';
import type { Loaded } from '../../../www/solver/types.ts';

test('what other code has written there keeps no file from being opened', () => {
  for (const text of ['null', '{}', '[1]', '[["x", null]]', 'words']) {
    setItem('shape-up.frames', text);
    assert.equal(rememberedFrame('a file'), '', text);
    rememberFrame('a file', { units: 'mm', up: 'y' }, { units: false, up: false });
    assert.equal(rememberedFrame('a file'), '# units: mm\n# up: y\n');
  }
});

test('what was only a guess is asked for again', () => {
  // Who corrected the unit alone had confirmed a guessed axis, too.
  const chosen = { units: false, up: true };
  const guessed = { units: true, up: true };
  const frame = { units: 'mm', up: 'z' } as const;
  rememberFrame('a file', frame, chosen);
  assert.equal(rememberedFrame('a file'), '# units: mm\n');
  const state = {
    document: frame as unknown as SceneDocument,
    model: { guessed: { units: 'm', up: 'z' } } as Loaded,
    frameChosen: { digest: '', units: false, up: false },
  };
  assert.deepEqual(frameOf(state).guessed, chosen);
  rememberFrame('a file', frame, guessed);
  assert.equal(rememberedFrame('a file'), '');
});
