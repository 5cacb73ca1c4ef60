// Which measure the solver evaluates for the colours of the faces.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Emitter } from '../../../www/solver/emitter.ts';
import { colourFaces } from '../../../www/store/colours/colour-scale.ts';
import { createStore } from '../../../www/store/state.ts';
import type { FaceMeasure, Document as SceneDocument } from '../../../www/pkg/engine/shape_up.js';
import type { Measure } from '../../../www/solver/types.ts';
import type { SolverClient } from '../../../www/solver/solver-client.ts';

const aTask = () => new Promise((done) => setTimeout(done));

test('a measure that does not exist, as in a mistyped address, colours nothing: the solver would stop at it', async () => {
  const store = createStore();
  const asked: (Measure | null)[] = [];
  const show = ({ measure }: { measure: Measure | null }) => asked.push(measure);
  const solver = Object.assign(new Emitter(), { tell: { show }, geometry: null });
  colourFaces(store, solver as unknown as SolverClient, () => null);
  // The scene may name its measure before the solver has declared it.
  store.set({ measure: 'planarity' });
  await aTask();
  store.set({ measures: [{ id: 'planarity' } as FaceMeasure] });
  await aTask();
  store.set({ measure: 'flatness' });
  await aTask();
  assert.deepEqual(asked, [null, null, 'planarity', null]);
});

test('the colours follow what the scene asks for, until the user chooses a measure', async () => {
  const store = createStore();
  const solver = Object.assign(new Emitter(), { tell: { show() {} }, geometry: null });
  colourFaces(store, solver as unknown as SolverClient, () => null);
  const open = async (measure: Measure | null) => {
    store.set({ document: { measure } as unknown as SceneDocument });
    await aTask();
    return store.get().measure;
  };
  assert.equal(await open(null), null);
  assert.equal(await open('planarity'), 'planarity');
  // It used to stay on the first measure.
  assert.equal(await open('circularity'), 'circularity');
  store.set({ measure: 'moved', measureChosen: true });
  assert.equal(await open('planarity'), 'moved');
});
