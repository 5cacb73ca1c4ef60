// When the colours of the constraint rows are asked for.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { colourRows } from '../../../www/store/colours/constraint-colours.ts';
import { createStore, type State } from '../../../www/store/state.ts';
import type { SolverClient } from '../../../www/solver/solver-client.ts';
import type { Actions } from '../../../www/store/actions.ts';

const tick = () => new Promise((done) => setTimeout(done));

test('rows that read the same have other colours once a set of that name has other members', async () => {
  let members = 'the eaves';
  const solver = { on() {}, ask: { rowColours: async () => members } } as unknown as SolverClient;
  const actions = { reportErrors: (asked: unknown) => Promise.resolve(asked) } as Actions;
  const store = createStore();
  const edited = async () => {
    const constraints = [{ on: 'the vertices of eaves', enabled: true }];
    store.set({ document: { constraints } as State['document'] });
    await tick();
    return store.get().rowColours as unknown;
  };
  colourRows(store, solver, actions);
  assert.equal(await edited(), 'the eaves');
  members = 'the ridge';
  assert.equal(await edited(), 'the ridge');
});
