// The parts that are shown, when another mesh is opened.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { AppContext } from '../../../www/app/context.ts';
import { theParts } from '../../../www/features/build/parts.ts';
import { calling } from '../../../www/solver/remote.ts';
import { createStore, type State } from '../../../www/store/state.ts';

const mesh = () => ({
  ...{ faceOffsets: Uint32Array.of(0, 3), faceIndices: Uint32Array.of(0, 1, 2) },
  ...{ untouchedOffsets: Uint32Array.of(0), untouchedIndices: new Uint32Array(0) },
  unplaced: new Uint32Array(0),
});
const soon = () => new Promise((done) => setTimeout(done));

test('parts of a mesh are neither kept nor shown once another one is open', async () => {
  // A press on a part or a check selected panels of the new mesh, or some that it does not have.
  const store = createStore();
  /** Ends the builds that were begun. */
  const ends: (() => void)[] = [];
  const built = { report: {}, words: { card: {} }, layer: null };
  const jobs = {
    generation: 0,
    ask: calling((name) => {
      if (name === 'buildOffers') return Promise.resolve({ presets: [], defaults: {} });
      if (name !== 'build') return Promise.resolve([]);
      return new Promise((done) => ends.push(() => done(built)));
    }),
  };
  const solver = { geometry: {} };
  let generation = 0;
  /** Opens a mesh. */
  async function open() {
    const positions = new Float64Array(9);
    solver.geometry = { generation: ++generation, positions, connectivity: mesh() };
    const document = { units: 'm', build: {}, handles: [] } as unknown as State['document'];
    store.set({ model: { vertices: 3, faces: 1 } as State['model'], document });
    await soon();
  }
  const actions = { look() {}, tint() {}, reportErrors: (made: unknown) => made };
  const viewport = { on() {}, unmeasured() {} };
  await open();
  const app = { store, jobs, solver, actions, viewport } as unknown as AppContext;
  const parts = theParts(app);
  const end = parts.begin();
  await soon();
  ends[0]();
  await soon();
  assert.ok(parts.built.value && parts.card.value);
  await open();
  assert.equal(parts.built.value, null);
  assert.equal(parts.card.value, null);
  // The build of the second mesh ends when a third one is open.
  await open();
  ends[1]();
  await soon();
  assert.equal(parts.built.value, null);
  ends[2]();
  await soon();
  assert.ok(parts.built.value);
  end();
});
