// The axes of plots.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { tickExponents } from '../../../www/ui/plot/ticks.ts';

test('the ticks of a logarithmic axis are whole powers of ten, evenly spaced, at most seven', () => {
  assert.deepEqual(tickExponents(-2, 1), [-2, -1, 0, 1]);
  assert.deepEqual(tickExponents(-14, 0), [-14, -11, -8, -5, -2]);
  assert.deepEqual(tickExponents(1, 0), []);
});
