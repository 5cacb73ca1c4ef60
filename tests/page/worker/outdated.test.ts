// What was asked of a mesh or a model that has been replaced meanwhile.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { answerIfReplaced } from '../../../www/worker/outdated.ts';
import type { Edit } from '../../../www/pkg/engine/shape_up.js';

/** The answer to a call of the page that shows mesh 2, when the first mesh of the model is `first`. */
const answer = (name: string, edit: Edit | null, first: number, now: number) =>
  answerIfReplaced({ name, given: [edit], mesh: 2 }, [first, now]);
const weights: Edit = { setWeights: { close: 3 } };
const fixed: Edit = { addHandles: { vertices: [4], fixed: true } };

test('an edit reaches the model whose mesh is refined meanwhile, unless it names elements', () => {
  // A weight that was typed while the mesh was refined was dropped without a word.
  const faces = { on: { each: 'face', in: '' }, set: { faces: [1] } };
  const remesh = { operation: 'dual', sizes: [] };
  for (const edit of [
    weights,
    'reset',
    { addConstraint: { kind: 'plane', on: 'faces', weight: 1, params: {} } },
    { holdClose: { vertices: null, weight: 1 } },
    { remesh: { ...remesh, vertices: [], faces: [] } },
  ] as Edit[])
    assert.equal(answer('edit', edit, 1, 3), undefined, JSON.stringify(edit));
  for (const edit of [
    fixed,
    { addConstraint: { kind: 'plane', ...faces, weight: 1, params: {} } },
    { addConstraint: { kind: 'sphere', on: { vertices: '0-8' }, weight: 1, params: {} } },
    { nameSet: { name: 'rim', vertices: [], faces: [2] } },
    { remesh: { ...remesh, vertices: [], faces: [7] } },
  ] as Edit[])
    assert.equal(answer('edit', edit, 1, 3), 'refused', JSON.stringify(edit));
});

test('what is about another model, or has values of another mesh, is not done', () => {
  assert.equal(answer('edit', weights, 3, 3), 'outdated');
  assert.equal(answer('editAndRun', weights, 3, 4), 'outdated');
  for (const name of ['drag', 'recycle', 'setBuildNumbers'])
    assert.equal(answer(name, null, 1, 3), 'outdated');
  // Neither is this about a mesh, nor has it been replaced.
  assert.equal(answer('run', null, 3, 3), undefined);
  assert.equal(answer('edit', fixed, 2, 2), undefined);
});
