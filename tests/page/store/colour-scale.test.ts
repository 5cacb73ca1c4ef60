// Which measure the solver evaluates for the colours of the faces.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Emitter } from '../../../www/solver/emitter.ts';
import { colourFaces } from '../../../www/store/colours/colour-scale.ts';
import { createStore } from '../../../www/store/state.ts';
import type { FaceMeasure, Measure } from '../../../www/solver/types.ts';
import type { SolverClient } from '../../../www/solver/solver-client.ts';

const aTask = () => new Promise((done) => setTimeout(done));

test('a measure that does not exist, as in a mistyped address, colours nothing: the solver would stop at it', async () => {
  const store = createStore();
  const asked: (Measure | null)[] = [];
  const show = ({ measure }: { measure: Measure | null }) => asked.push(measure);
  const solver = Object.assign(new Emitter(), { tell: { show }, geometry: null });
  colourFaces(store, solver as unknown as SolverClient);
  // The scene may name its measure before the solver has declared it.
  store.set({ measure: 'planarity' });
  await aTask();
  store.set({ measures: [{ id: 'planarity' } as FaceMeasure] });
  await aTask();
  store.set({ measure: 'flatness' });
  await aTask();
  assert.deepEqual(asked, [null, null, 'planarity', null]);
});
