// Index lists and positions of a scene as the page reads them, and the layers made of its groups.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  byLayer,
  curvesLayer,
  indices,
  pointsOf,
} from '../../../www/documents/rhino/scene-lists.ts';
import type { Point, SceneText } from '../../../www/solver/scene-text.ts';

test('ranges include both ends, and an empty list has no index', () => {
  assert.deepEqual(indices('0-3,7'), [0, 1, 2, 3, 7]);
  assert.deepEqual(indices([4, 2]), [4, 2]);
  // It used to be read as [0]: the first face came onto the layer of a group without faces.
  assert.deepEqual(indices(''), []);
  assert.deepEqual(indices(' '), []);
});

test('groups of the same name form one layer, whichever statement defined them', () => {
  const groups = {
    // `o roof` and `g roof` of an OBJ: a scene lists both in an array, which was once read as one
    // group.
    roof: [{ faces: '0-1', keyword: 'o' }, { faces: [1, 3] }],
    wall: { faces: '3-4' },
    none: { faces: '' },
  };
  const layers = Object.fromEntries(byLayer(6, groups));
  assert.deepEqual(layers, { roof: [0, 1, 3], Panels: [2, 5], wall: [4] });
});

test('the faces of no group, and the curves, are on layers of their own', () => {
  // They were merged into groups of these names.
  const groups = { Panels: { faces: [0] }, Curves: { faces: [1] }, 'Curves 2': { faces: [2] } };
  const layers = Object.fromEntries(byLayer(4, groups));
  assert.deepEqual(layers, { Panels: [0], Curves: [1], 'Curves 2': [2], 'Panels 2': [3] });
  assert.equal(curvesLayer(groups), 'Curves 3');
});

test('a Rhino file has the current shape, of a scene saved at its design that variant', () => {
  const mesh: SceneText['mesh'] = { positions: [[0, 0, 0]] };
  const kept: { positions: Point[] }[] = [{ positions: [[1, 2, 3]] }, { positions: [[4, 5, 6]] }];
  assert.deepEqual(pointsOf({ mesh }), [[0, 0, 0]]);
  assert.deepEqual(pointsOf({ mesh, variants: { kept } }), [[0, 0, 0]]);
  assert.deepEqual(pointsOf({ mesh, variants: { kept, design: 1 } }), [[4, 5, 6]]);
  const current: Point[] = [[7, 8, 9]];
  assert.deepEqual(pointsOf({ mesh, variants: { kept, design: 1 }, current, up: 'y' }), [
    [7, -9, 8],
  ]);
});
