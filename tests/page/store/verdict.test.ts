// The verdict on the panels in the state of the page.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createStore, type State } from '../../../www/store/state.ts';
import { createViewActions } from '../../../www/store/view-actions.ts';
import type { BetterPress } from '../../../www/solver/types.ts';

const FOUND = [{ id: 'tolerance' }] as BetterPress[];

function judged() {
  const store = createStore();
  const actions = createViewActions(store);
  const verdict = { shape: 3, report: { level: 'fair', suggestions: [] } };
  actions.judge(verdict as unknown as State['verdict']);
  return { store, actions };
}

test('better presses that are found later leave a closed verdict closed', () => {
  // Its closing was forgotten with the next press that was found, and Build was not proposed.
  const { store, actions } = judged();
  const { verdict } = store.get();
  if (verdict) actions.judge({ ...verdict, isClosed: true });
  actions.suggest(3, FOUND);
  assert.equal(store.get().verdict?.isClosed, true);
  assert.deepEqual(store.get().verdict?.report.suggestions, FOUND);
});

test('those for another shape are dropped, also after its verdict is gone', () => {
  const { store, actions } = judged();
  actions.suggest(4, FOUND);
  assert.deepEqual(store.get().verdict?.report.suggestions, []);
  actions.judge(null);
  actions.suggest(3, FOUND);
  actions.suggest(undefined, FOUND);
  assert.equal(store.get().verdict, null);
});
