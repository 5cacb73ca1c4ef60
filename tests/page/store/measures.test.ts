// How the values of measures are displayed.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { toleranceOf, unitOf, valueInWords } from '../../../www/store/colours/measures.ts';
import type { State } from '../../../www/store/state.ts';

const about = { id: 'bend', label: '', words: '', met: '', toleranced: false, curvature: true };
const mean = { ...about, unit: 'per-length' as const, signed: true };
const gauss = { ...about, unit: 'per-area' as const, signed: true };

test('curvatures are shown per metre, whatever the unit of the mesh', () => {
  assert.deepEqual(unitOf(mean, 1, 'm'), { unit: '1/m', factor: 1 });
  assert.equal(valueInWords(mean, 0.002, 'mm'), '2.00 1/m');
  assert.equal(valueInWords(gauss, -2e-6, 'mm'), '−2.00 1/m²');
  assert.equal(valueInWords(gauss, 0.25, 'm'), '0.250 1/m²');
  // A mesh without a unit shows none.
  assert.equal(valueInWords(gauss, 0.25, ''), '0.250');
  assert.equal(valueInWords({ ...about, signed: false, unit: 'percent' }, 3, 'm'), '3.00 %');
  assert.equal(valueInWords({ ...about, signed: false, unit: 'degrees' }, 3, 'm'), '3.00°');
});

test('a signed value has no tolerance', () => {
  const state = { document: { tolerance: 0.01 }, tolerances: { bend: 3 } } as unknown as State;
  assert.equal(toleranceOf(state, mean), null);
  assert.equal(toleranceOf(state, { ...mean, signed: false }), 3);
});
