// The store: which listeners are notified, and when.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { handlesNow } from '../../../www/store/handles.ts';
import { createStore, hasMoved, withModel, type State } from '../../../www/store/state.ts';
import type { Loaded } from '../../../www/solver/types.ts';

const reported: string[] = [];
globalThis.reportError = (error) => reported.push(error.message);

test('a listener is called once per task, and only for its own keys', async () => {
  const store = createStore();
  const heard: string[] = [];
  store.subscribe(['status'], ({ status }) => heard.push(status));
  store.set({ status: 'one' });
  store.set({ status: 'two' });
  store.set({ fileName: 'roof.obj' });
  await Promise.resolve();
  assert.deepEqual(heard, ['', 'two']);
  store.set({ fileName: 'dome.obj' });
  store.set({ status: 'two' });
  await Promise.resolve();
  assert.deepEqual(heard, ['', 'two']);
});

test('a listener that throws does not affect the others', async () => {
  const store = createStore();
  const heard: string[] = [];
  store.subscribe(['status'], ({ status }) => {
    if (status) throw new Error(status);
  });
  store.subscribe(['status'], ({ status }) => heard.push(status));
  store.set({ status: 'broken' });
  await Promise.resolve();
  assert.deepEqual(heard, ['', 'broken']);
  assert.deepEqual(reported, ['broken']);
});

test('a shape that only constraints have moved is no longer the original', () => {
  // A run that begins by meeting them stays at iteration 0: it was taken for the unsolved start.
  const moved = (iteration: number, max: number) =>
    hasMoved({ iteration, moved: { max } } as State['numbers']);
  assert.deepEqual(
    [hasMoved(null), moved(0, 0), moved(0, 1), moved(1, 0)],
    [false, false, true, true],
  );
});

test('dragged handles have the targets of the drag', () => {
  const handle = (vertex: number) => ({ vertex, target: [0, 0, 0], weight: 1, fixed: false });
  const state = {
    document: { handles: [handle(3), handle(7)] },
    dragged: [7],
    moved: { by: [1, 2, 3], targets: Float64Array.of(1, 2, 3) },
  } as unknown as State;
  const targets = handlesNow(state).map(({ target }) => target);
  assert.deepEqual(targets, [
    [0, 0, 0],
    [1, 2, 3],
  ]);
  assert.deepEqual(handlesNow({ ...state, document: null }), []);
});

test('a presentation outlasts another mesh of its model, and ends with the model', () => {
  const store = createStore();
  for (const restoring of [true, false]) {
    store.set({ presenting: true });
    store.set(withModel({} as Loaded, { restoring, reopensSameMesh: false }));
    assert.equal(store.get().presenting, restoring);
  }
});

test('why the parts of one lesson could not be built is not said of the next one', () => {
  const store = createStore();
  store.set({ goalsRefused: 'Cancelled.' });
  store.set(withModel({} as Loaded, { restoring: false, reopensSameMesh: false }));
  assert.equal(store.get().goalsRefused, '');
});
