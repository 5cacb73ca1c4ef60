// Which tolerance a measure has.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { toleranceOf } from '../../../www/store/colours/measures.ts';
import type { State } from '../../../www/store/state.ts';

const about = { id: 'bend', label: '', words: '', met: '', toleranced: false, curvature: true };
const mean = { ...about, unit: 'per-length' as const, signed: true };

test('a signed value has no tolerance', () => {
  const state = { document: { tolerance: 0.01 }, tolerances: { bend: 3 } } as unknown as State;
  assert.equal(toleranceOf(state, mean), null);
  assert.equal(toleranceOf(state, { ...mean, signed: false }), 3);
});
