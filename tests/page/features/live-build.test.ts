// When the parts are built again.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { AppContext } from '../../../www/app/context.ts';
import { LiveBuild } from '../../../www/features/build/live-build.ts';
import type { Shape } from '../../../www/features/build/build-worker.ts';
import type { Call } from '../../../www/solver/remote.ts';

/** Nothing is under way. */
const actions = { settled: async () => {} };

/** The shape of a call to build; undefined for other calls. */
const shapeOf = ({ name, given }: Call) => (name === 'build' ? (given[0] as Shape) : undefined);

test('faces that change during a build are built, although no vertex has moved', async () => {
  /** Corners of the meshes that were built. */
  const built: number[] = [];
  /** Called when a build has begun. */
  let begun = () => {};
  globalThis.Worker = class {
    onmessage: (event: { data: object }) => void = () => {};
    postMessage(call: Call) {
      const shape = shapeOf(call);
      if (shape) built.push(shape.indices.length);
      begun();
      const value = call.name === 'offers' ? { presets: [], defaults: {} } : {};
      const { id } = call;
      setTimeout(() => this.onmessage({ data: { id, value } }));
    }
  } as unknown as typeof Worker;
  const positions = Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
  const mesh = (generation: number, offsets: number[], indices: number[]) => ({
    ...{ generation, positions },
    connectivity: {
      faceOffsets: Uint32Array.from(offsets),
      faceIndices: Uint32Array.from(indices),
    },
  });
  const state = {
    ...{ model: { faces: 1, vertices: 4 }, dragged: [], running: false },
    document: { units: 'm', build: {} },
  };
  const solver = { geometry: mesh(1, [0, 3, 6], [0, 1, 2, 0, 2, 3]) };
  const app = { store: { get: () => state }, solver, actions } as unknown as AppContext;
  const live = new LiveBuild(app, {
    show() {},
    showOffset() {},
    refuse: (why) => assert.fail(why),
  });
  await live.offers();
  begun = () => {
    begun = () => {};
    // The triangles are joined to a quad.
    solver.geometry = mesh(2, [0, 4], [0, 1, 2, 3]);
    void live.update();
  };
  await live.update();
  assert.deepEqual(built, [6, 4]);
  await live.update();
  assert.deepEqual(built, [6, 4]);
});

test('what is saved while a large shape moves is built of its current positions', async () => {
  /** The first coordinate of each request, and its type. */
  const asked: (string | number)[] = [];
  globalThis.Worker = class {
    onmessage: (event: { data: object }) => void = () => {};
    postMessage(call: Call) {
      asked.push(shapeOf(call)?.positions[0] ?? call.name);
      const value = call.name === 'offers' ? { presets: [], defaults: {} } : {};
      const { id } = call;
      setTimeout(() => this.onmessage({ data: { id, value } }));
    }
  } as unknown as typeof Worker;
  const connectivity = { faceOffsets: Uint32Array.of(0, 3), faceIndices: Uint32Array.of(0, 1, 2) };
  const positions = Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0);
  const state = {
    ...{ model: { faces: 1, vertices: 100_000 }, dragged: [], running: false },
    document: { units: 'm', build: {} },
  };
  const geometry = { generation: 1, positions, connectivity };
  const app = {
    ...{ store: { get: () => state }, solver: { geometry }, actions },
  } as unknown as AppContext;
  const refuse = (why: string) => assert.fail(why);
  const live = new LiveBuild(app, { show() {}, showOffset() {}, refuse });
  await live.offers();
  await live.update();
  state.running = true;
  positions[0] = 7;
  geometry.generation = 2;
  await live.update();
  assert.deepEqual(asked.splice(0), ['offers', 0]);
  await live.zip();
  await live.spatialParts();
  positions[0] = 8;
  geometry.generation = 3;
  await live.reportPage({ title: '', camera: null, link: '' });
  assert.deepEqual(asked, [7, 'zip', 'spatialParts', 8, 'reportPage']);
});

test('another shape is built, even one with equal sums of its coordinates', async () => {
  /** The first coordinate of each shape that was built. */
  const built: number[] = [];
  globalThis.Worker = class {
    onmessage: (event: { data: object }) => void = () => {};
    postMessage(call: Call) {
      const shape = shapeOf(call);
      if (shape) built.push(shape.positions[0]);
      const value = call.name === 'offers' ? { presets: [], defaults: {} } : {};
      const { id } = call;
      setTimeout(() => this.onmessage({ data: { id, value } }));
    }
  } as unknown as typeof Worker;
  const connectivity = { faceOffsets: Uint32Array.of(0, 3), faceIndices: Uint32Array.of(0, 1, 2) };
  const shape = (generation: number, ...positions: number[]) => ({
    ...{ generation, connectivity, positions: Float64Array.from(positions) },
  });
  const state = {
    ...{ model: { faces: 1, vertices: 3 }, dragged: [], running: false },
    document: { units: 'm', build: {} },
  };
  const solver = { geometry: shape(1, 1, 0, 0, 0, 1, 0, 0, 5, 0) };
  const app = { store: { get: () => state }, solver, actions } as unknown as AppContext;
  const refuse = (why: string) => assert.fail(why);
  const live = new LiveBuild(app, { show() {}, showOffset() {}, refuse });
  await live.offers();
  await live.update();
  // The first and the eighth coordinate had the same weight in a check sum.
  solver.geometry = shape(2, 5, 0, 0, 0, 1, 0, 0, 1, 0);
  await live.update();
  await live.update();
  assert.deepEqual(built, [1, 5]);
});

test('what is saved is built with the settings that were set just before', async () => {
  /** The scale of each build, and the other calls. */
  const asked: (number | string)[] = [];
  globalThis.Worker = class {
    onmessage: (event: { data: object }) => void = () => {};
    postMessage(call: Call) {
      asked.push(shapeOf(call)?.settings.scale ?? call.name);
      const value = call.name === 'offers' ? { presets: [], defaults: {} } : {};
      const { id } = call;
      setTimeout(() => this.onmessage({ data: { id, value } }));
    }
  } as unknown as typeof Worker;
  const state = {
    ...{ model: { faces: 1, vertices: 3 }, dragged: [], running: false },
    document: { units: 'm', build: { scale: 10 } },
  };
  const connectivity = { faceOffsets: Uint32Array.of(0, 3), faceIndices: Uint32Array.of(0, 1, 2) };
  const geometry = { generation: 1, positions: new Float64Array(9), connectivity };
  // The solver answers an edit later.
  const settled = async () => {
    await new Promise((done) => setTimeout(done, 5));
    state.document = { units: 'm', build: { scale: 20 } };
  };
  const app = {
    ...{ store: { get: () => state }, solver: { geometry }, actions: { settled } },
  } as unknown as AppContext;
  const refuse = (why: string) => assert.fail(why);
  const live = new LiveBuild(app, { show() {}, showOffset() {}, refuse });
  await live.offers();
  await live.update();
  await live.zip();
  assert.deepEqual(asked, ['offers', 10, 20, 'zip']);
});
