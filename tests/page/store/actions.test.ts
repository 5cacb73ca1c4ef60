// What is asked of the solver once, and which handles are held.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createActions } from '../../../www/store/actions.ts';
import { Emitter } from '../../../www/solver/emitter.ts';
import { createStore, type State } from '../../../www/store/state.ts';
import type { Alerts } from '../../../www/ui/controls/alerts.tsx';
import type { JobsClient } from '../../../www/solver/jobs-client.ts';
import type { SolverClient } from '../../../www/solver/solver-client.ts';

test('the original is asked for once for every model', async () => {
  const solverEvents = new Emitter<{ model: object }>();
  let asked = 0;
  const solver = {
    on: solverEvents.on.bind(solverEvents),
    ask: { originalPositions: async () => ++asked },
    ...{ change: {}, tell: {} },
  } as unknown as SolverClient;
  const { originalPositions } = createActions(
    createStore(),
    solver,
    { of: () => ({}) } as unknown as JobsClient,
    {} as Alerts,
  );
  assert.equal(await originalPositions(), 1);
  assert.equal(await originalPositions(), 1);
  solverEvents.emit('model', {});
  assert.equal(await originalPositions(), 2);
});

/** Actions on these handles, fixed or not, by vertex; with the edits that they send. */
function holding(handles: [vertex: number, fixed: boolean][], selected: number[]) {
  const store = createStore();
  const known = handles.map(([vertex, fixed]) => ({ vertex, fixed }));
  store.set({
    document: { handles: known, constraints: [] } as unknown as State['document'],
    selection: { ...store.get().selection, vertices: new Set(selected) },
  });
  const sent: unknown[] = [];
  const change = {
    edit: async (edit: unknown) => {
      sent.push(edit);
      return null;
    },
  };
  const geometry = { connectivity: { edges: [], faceOffsets: [], faceIndices: [] } };
  const given = { ...{ on() {}, ask: {}, tell: {} }, change, geometry, settled: async () => {} };
  const solver = given as unknown as SolverClient;
  return {
    store,
    sent,
    actions: createActions(
      store,
      solver,
      { of: () => ({}) } as unknown as JobsClient,
      {} as Alerts,
    ),
  };
}

test('making handles leaves fixed ones fixed, and making them soft makes no new ones', async () => {
  const { store, sent, actions } = holding([[1, true]], [1, 2, 3]);
  await actions.holdSelected(false);
  assert.equal(store.get().status, '2 handles added');
  await actions.softenSelected();
  assert.equal(store.get().status, '1 handle made soft');
  await actions.holdSelected(true);
  assert.equal(store.get().status, '2 handles fixed');
  assert.deepEqual(sent, [
    { addHandles: { vertices: [2, 3], fixed: false } },
    { addHandles: { vertices: [1], fixed: false } },
    { addHandles: { vertices: [2, 3], fixed: true } },
  ]);
});
