// One press for all panels, and what it leaves of the fitted shapes.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Emitter } from '../../../www/solver/emitter.ts';
import { createStore, showsFitted, withModel } from '../../../www/store/state.ts';
import { createViewActions } from '../../../www/store/view-actions.ts';
import type { AppContext } from '../../../www/app/context.ts';
import type { KindWords } from '../../../www/pkg/engine/shape_up.js';
import type { Loaded } from '../../../www/solver/types.ts';

globalThis.matchMedia = () => ({ matches: false }) as MediaQueryList;
const { makePanels } = await import('../../../www/features/make-panels/press.ts');

/** A page on which fitted shapes are shown or hidden. */
function page(shown: boolean) {
  const store = createStore();
  const view = createViewActions(store);
  const panels = [{ kind: 'circle', reason: null }];
  const open = (restoring = false, reopensSameMesh = false) =>
    store.set(withModel({ panels } as unknown as Loaded, { restoring, reopensSameMesh }));
  open();
  view.display({ shapes: shown });
  const solver = new Emitter<{ activity: { running: boolean; converged: boolean } }>();
  const made: unknown[] = [];
  const make = async (_: string, within?: number): Promise<null | undefined> => {
    made.push(within);
    return null;
  };
  const actions = { ...view, makePanels: make };
  let end = () => {};
  const transition = () => {
    end();
    return new Promise<void>((done) => (end = done));
  };
  const app = {
    ...{ store, solver, actions, viewport: { transition, endTransition: () => end() } },
    files: {
      openings: { coming: null as Promise<void> | null },
      untilOpen: () => app.files.openings.coming,
    },
  };
  const isShown = () => showsFitted(store.get());
  const press = () => {
    void makePanels(app as unknown as AppContext, { id: 'circle' } as KindWords);
    assert.equal(isShown(), false, 'those of the final shape are not known yet');
  };
  const arrive = async () => {
    end();
    await new Promise((done) => setTimeout(done));
  };
  /** Presses while another model is being opened, or one is refused. */
  const pressBefore = async (how: { within: number } | undefined, opens: () => void) => {
    app.files.openings.coming = Promise.resolve().then(opens);
    void makePanels(app as unknown as AppContext, { id: 'circle' } as KindWords, how);
    await new Promise((done) => setTimeout(done));
    return made.splice(0);
  };
  return { ...{ press, pressBefore, arrive, open, isShown }, app, store, view };
}

/** Whether fitted shapes are shown after a press, during whose transition another model comes. */
async function shownAfter(before: boolean, another: boolean) {
  const { press, arrive, open, isShown } = page(before);
  press();
  if (another) open();
  await arrive();
  return isShown();
}

test('the fitted shapes are shown after the transition', async () => {
  assert.equal(await shownAfter(false, false), true);
});

test('a model that is opened during the transition has the shapes shown or hidden as before', async () => {
  // They stayed hidden.
  assert.equal(await shownAfter(true, true), true);
  assert.equal(await shownAfter(false, true), false);
});

test('a model that is opened during the transition of a second press is shown as before the first', async () => {
  const late = page(false);
  late.press();
  await late.arrive();
  assert.equal(late.isShown(), true);
  late.press();
  late.open();
  await late.arrive();
  // What the first press had shown was taken for what the user had.
  assert.equal(late.isShown(), false);

  const early = page(true);
  early.press();
  early.press();
  early.open();
  await early.arrive();
  // And so was what it had hidden.
  assert.equal(early.isShown(), true);
});

test('a press outlasts a new worker, and the fitted shapes that it shows another mesh', async () => {
  // Its card and verdict did not come after Cancel of other work, and Refine hid the circles.
  const { press, arrive, isShown, app, open, store } = page(false);
  press();
  open(true, true);
  await arrive();
  assert.equal(isShown(), true);
  for (const running of [true, false]) app.solver.emit('activity', { running, converged: true });
  await arrive();
  assert.equal(store.get().press?.isUnderWay, false);
  open(true);
  assert.deepEqual([store.get().press, isShown()], [null, true]);
});

test('a press with a length is about the open model, a plain one about the next', async () => {
  // "4 panels within 12 mm" of a model in mm was done to the next one, in m.
  const { pressBefore, open } = page(false);
  assert.deepEqual(await pressBefore(undefined, open), [undefined]);
  assert.deepEqual(await pressBefore({ within: 12 }, open), []);
  assert.deepEqual(await pressBefore({ within: 12 }, () => {}), [12]);
});

test('a press that is refused leaves the card and the last press as they were', async () => {
  // One under a lesson's lock opened the card again that the user had closed.
  const { press, arrive, isShown, app, store, view } = page(false);
  press();
  await arrive();
  for (const running of [true, false]) app.solver.emit('activity', { running, converged: true });
  await arrive();
  view.closePanelsCard();
  const before = store.get();
  app.actions.makePanels = async () => undefined;
  press();
  await arrive();
  const { press: last, closedCard } = store.get();
  assert.deepEqual([last, closedCard], [before.press, before.closedCard]);
  assert.equal(isShown(), true);
});
