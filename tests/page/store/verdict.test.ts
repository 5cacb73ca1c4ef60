// The verdict on the panels in the state of the page.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { panelsCard } from '../../../www/store/panels-card.ts';
import { createStore, type State } from '../../../www/store/state.ts';
import { createViewActions } from '../../../www/store/view-actions.ts';
import type { BetterPress } from '../../../www/solver/types.ts';

const FOUND = [{ id: 'tolerance' }] as BetterPress[];

function judged() {
  const store = createStore();
  const actions = createViewActions(store);
  const verdict = { shape: 3, report: { level: 'fair', suggestions: [] } };
  actions.look({ verdict: verdict as unknown as State['verdict'] });
  return { store, actions };
}

test('the card has a verdict only while a constraint asks the panels for a shape', () => {
  // It said that all panels are circular when that row was off, and was empty with rows on edges only.
  const model = { faces: 4, panels: [{}] };
  const kinds = [
    { id: 'circle', panels: 'circular' },
    { id: 'edge', panels: null },
  ];
  const shown = (...constraints: object[]) =>
    panelsCard({ model, kinds, press: { model }, document: { constraints } } as unknown as State);
  const circle = { kind: 'circle', enabled: true };
  const edge = { kind: 'edge', enabled: true };
  assert.equal(shown(edge, circle), 'verdict');
  assert.equal(shown(edge, { ...circle, enabled: false }), null);
  assert.equal(shown(edge), null);
  assert.equal(shown(), 'offer');
});

test('those for another shape are dropped, also after its verdict is gone', () => {
  const { store, actions } = judged();
  actions.suggest(4, FOUND);
  assert.deepEqual(store.get().verdict?.report.suggestions, []);
  actions.look({ verdict: null });
  actions.suggest(3, FOUND);
  actions.suggest(undefined, FOUND);
  assert.equal(store.get().verdict, null);
});
