// Which measure the solver evaluates for the colours of the faces.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Emitter } from '../../../www/solver/emitter.js';
import { colourFaces } from '../../../www/store/colours/colour-scale.js';
import { createStore } from '../../../www/store/state.js';

const aTask = () => new Promise((done) => setTimeout(done));

test('a measure that does not exist, as in a mistyped address, colours nothing: the solver would stop at it', async () => {
  const store = createStore();
  const asked = [];
  const send = ({ measure }) => asked.push(measure);
  const solver = Object.assign(new Emitter(), { send, geometry: null });
  colourFaces(store, /** @type {any} */ (solver));
  // The scene may name its measure before the solver has declared it.
  store.set({ measure: 'planarity' });
  await aTask();
  store.set({ measures: /** @type {any} */ ([{ id: 'planarity' }]) });
  await aTask();
  store.set({ measure: 'flatness' });
  await aTask();
  assert.deepEqual(asked, [null, null, 'planarity', null]);
});
