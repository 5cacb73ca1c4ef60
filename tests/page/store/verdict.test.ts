// The verdict on the panels in the state of the page.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { verdicts } from '../../../www/features/make-panels/verdicts.ts';
import { Emitter } from '../../../www/solver/emitter.ts';
import { panelsCard, panelsTopic } from '../../../www/store/panels-card.ts';
import { createStore, type State } from '../../../www/store/state.ts';
import { createViewActions } from '../../../www/store/view-actions.ts';
import type { AppContext } from '../../../www/app/context.ts';
import type { BetterPress } from '../../../www/pkg/engine/shape_up.js';

globalThis.window = globalThis as unknown as typeof window;

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
    panelsCard({ model, kinds, press: {}, document: { constraints } } as unknown as State);
  const circle = { kind: 'circle', enabled: true };
  const edge = { kind: 'edge', enabled: true };
  assert.equal(shown(edge, circle), 'verdict');
  assert.equal(shown(edge, { ...circle, enabled: false }), null);
  assert.equal(shown(edge), null);
  assert.equal(shown(), 'offer');
});

test('the card is where there is room for it, and what there is to say does not depend on that', () => {
  // Style sheets hid a card whose message, offers and buttons were then nowhere.
  const model = { faces: 4, panels: [{}] };
  const kinds = [{ id: 'circle', panels: 'circular' }];
  const offered = { model, kinds, document: { constraints: [] } };
  const circle = { kind: 'circle', enabled: true };
  const judged = { ...offered, press: {}, document: { constraints: [circle] } };
  const where = (room: object) =>
    [offered, judged].map((known) => {
      const state = { ...known, room: 'wide', ...room } as unknown as State;
      return [panelsCard(state), panelsTopic(state)];
    });
  const both = [
    ['offer', 'offer'],
    ['verdict', 'verdict'],
  ];
  const none = both.map(([, topic]) => [null, topic]);
  for (const room of [{}, { room: 'small' }, { corner: 'curvature' }])
    assert.deepEqual(where(room), both, JSON.stringify(room));
  for (const room of [
    ...[{ docked: 'parts' }, { flatMap: {} }, { presenting: true }, { corner: 'new-panels' }],
    { corner: 'curvature', room: 'small' },
  ])
    assert.deepEqual(where(room), none, JSON.stringify(room));
  assert.deepEqual(where({ room: 'sheet' }), [both[0], none[1]]);
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

test('a verdict is asked for also where no card shows it', async () => {
  // After a run beside a flat map, Build was the next step for a shape that nobody had judged.
  const store = createStore();
  const model = { faces: 4, panels: [{}] };
  const asked = {
    ...{ model, press: { label: '' }, flatMap: {} },
    kinds: [{ id: 'circle', panels: 'circular' }],
    document: { constraints: [{ kind: 'circle', enabled: true }] },
  };
  store.set(asked as unknown as State);
  const solver = Object.assign(new Emitter<{ frame: void }>(), { geometry: { generation: 7 } });
  const ask = { verdict: async () => ({ level: 'good', brief: '', numbers: '' }) };
  const actions = { ...createViewActions(store), ask };
  verdicts({ store, solver, actions } as unknown as AppContext);
  await new Promise((done) => setTimeout(done));
  assert.equal(store.get().verdict?.shape, 7);
});
