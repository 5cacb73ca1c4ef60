// One press for all panels, and what it leaves of the fitted shapes.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Emitter } from '../../../www/solver/emitter.ts';
import { createStore, type State } from '../../../www/store/state.ts';
import type { AppContext } from '../../../www/app/context.ts';
import type { KindInfo } from '../../../www/solver/types.ts';

globalThis.matchMedia = () => ({ matches: false }) as MediaQueryList;
const { makePanels } = await import('../../../www/features/make-panels/press.ts');

/** Whether fitted shapes are shown after a press, during whose transition another model comes. */
async function shownAfter(before: boolean, another: boolean) {
  const store = createStore();
  const display = (change: object) => store.set({ display: { ...store.get().display, ...change } });
  store.set({ model: {} as State['model'] });
  display({ shapes: before });
  const solver = new Emitter<{ activity: { running: boolean; converged: boolean } }>();
  const actions = { display, pressed() {}, pressTurns() {}, makePanels: async () => null };
  let arrive = () => {};
  const arrived = new Promise<void>((done) => (arrive = done));
  const viewport = { transition: () => arrived };
  const app = { store, solver, actions, viewport, files: { openings: { coming: null } } };
  void makePanels(app as unknown as AppContext, { id: 'circle' } as KindInfo);
  assert.equal(store.get().display.shapes, false, 'those of the final shape are not known yet');
  if (another) store.set({ model: {} as State['model'] });
  arrive();
  await new Promise((done) => setTimeout(done));
  return store.get().display.shapes;
}

test('the fitted shapes are shown after the transition', async () => {
  assert.equal(await shownAfter(false, false), true);
});

test('a model that is opened during the transition has the shapes shown or hidden as before', async () => {
  // They stayed hidden.
  assert.equal(await shownAfter(true, true), true);
  assert.equal(await shownAfter(false, true), false);
});
