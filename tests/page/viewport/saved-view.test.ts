// What of a saved view comes back.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { restoreView, viewOf } from '../../../www/viewport/saved-view.ts';
import { createStore, type State } from '../../../www/store/state.ts';
import type { Actions } from '../../../www/store/actions.ts';

/** The measure and the step after a model that was left with this view is opened again. */
function restored(left: Partial<State>) {
  const store = createStore();
  store.set(left);
  const view = JSON.parse(JSON.stringify(viewOf(store.get())));
  // A scene that is opened suggests a measure.
  const measures = ['planarity', 'circularity'].map((id) => ({ id }));
  store.set({ measure: 'planarity', measures: measures as State['measures'], step: 'open' });
  const actions = { look: (look: Partial<State>) => store.set(look) };
  restoreView(view, store, actions as Actions);
  const { measure, step } = store.get();
  return [measure, step];
}

test('a measure that was chosen comes back, and so does none', () => {
  assert.deepEqual(restored({ measure: 'circularity', step: 'check' }), ['circularity', 'check']);
  // “Colour by: nothing” was lost.
  assert.deepEqual(restored({ measure: null, measureChosen: true }), [null, 'shape']);
});

test('where there is no such measure, that of the scene stays', () => {
  assert.deepEqual(restored({ measure: 'of an old version' }), ['planarity', 'shape']);
  assert.deepEqual(restored({ measure: null, measureChosen: false }), ['planarity', 'shape']);
});
