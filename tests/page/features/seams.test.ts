// The edges along which paper is cut: which of the selected ones they are.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { selectedEdges, without } from '../../../www/features/build/seams.ts';
import { NOTHING } from '../../../www/store/selection.ts';
import type { Connectivity } from '../../../www/solver/types.ts';

/** Two quads, 0 1 4 3 and 1 2 5 4, and an edge of no face, 2 6. */
const mesh = {
  faceOffsets: Uint32Array.of(0, 4, 8),
  faceIndices: Uint32Array.of(0, 1, 4, 3, 1, 2, 5, 4),
  edges: Uint32Array.of(0, 1, 4, 1, 3, 4, 0, 3, 1, 2, 2, 5, 4, 5, 2, 6),
} as Connectivity;

test('of the selected edges those between faces are meant, or those between selected vertices', () => {
  const all = { ...NOTHING, edges: new Set([0, 1, 2, 3, 4, 5, 6, 7]) };
  assert.deepEqual(selectedEdges(all, mesh), [[4, 1]]);
  assert.deepEqual(selectedEdges({ ...NOTHING, edges: new Set([0, 7]) }, mesh), []);
  assert.deepEqual(selectedEdges({ ...NOTHING, vertices: new Set([1, 4, 5]) }, mesh), [[4, 1]]);
  const other = { ...NOTHING, vertices: new Set([1, 4]), edges: new Set([0]) };
  assert.deepEqual(selectedEdges(other, mesh), [], 'edges come first');
  assert.deepEqual(selectedEdges({ ...NOTHING, faces: new Set([0, 1]) }, mesh), []);
});

test('an edge is the same from either end', () => {
  assert.deepEqual(
    without(
      [
        [4, 1],
        [2, 3],
      ],
      [[1, 4]],
    ),
    [[2, 3]],
  );
  assert.deepEqual(without([[4, 1]], []), [[4, 1]]);
});
