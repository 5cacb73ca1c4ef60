// When the parts are built again.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { AppContext } from '../../../www/app/context.ts';
import { LiveBuild } from '../../../www/features/build/live-build.ts';
import { Cancelled } from '../../../www/solver/errors.ts';
import { calling } from '../../../www/solver/remote.ts';
import type { Shape } from '../../../www/worker/jobs/build.ts';

/** A second worker that answers every call, after telling of it. */
const jobsThat = (hear: (name: string, shape: Shape | undefined) => void) => ({
  generation: 0,
  ask: calling((name, given) => {
    hear(name, name === 'build' ? (given[1] as Shape) : undefined);
    const value = name === 'buildOffers' ? { presets: [], defaults: {} } : {};
    return new Promise((resolve) => setTimeout(resolve, 0, value));
  }),
});
/** A triangle of a file without faces that are left as they are, and without guessed positions. */
const triangle = {
  ...{ faceOffsets: Uint32Array.of(0, 3), faceIndices: Uint32Array.of(0, 1, 2) },
  ...{ untouchedOffsets: Uint32Array.of(0), untouchedIndices: new Uint32Array(0) },
  unplaced: new Uint32Array(0),
};
/** A document in which nothing is held. */
const DOCUMENT = {
  ...{ units: 'm', up: 'z', build: {} },
  handles: [] as { vertex: number; fixed: boolean }[],
};
/** Nothing is under way. */
const actions = { settled: async () => {} };

/** A page with a triangle, and these parts of its own. */
function withTriangle(own: object, refuse: (why: string) => unknown = assert.fail) {
  const state = {
    ...{ model: { faces: 1, vertices: 3 }, dragged: [], running: false },
    document: { ...DOCUMENT },
  };
  const geometry = { generation: 1, positions: new Float64Array(9), connectivity: triangle };
  const app = { store: { get: () => state }, solver: { geometry }, actions, ...own };
  const on = { show() {}, showOffset() {}, refuse };
  return { state, live: new LiveBuild(app as unknown as AppContext, 'panel', on) };
}

test('a build is out of date with the shape and with the document, which has its settings', async () => {
  // Goals of a lesson were met or missed by numbers of the settings before.
  const { state, live } = withTriangle({ jobs: jobsThat(() => {}) });
  await live.offers();
  await live.update();
  assert.equal(live.isCurrent(), true);
  state.document = { ...DOCUMENT };
  assert.equal(live.isCurrent(), false);
  await live.again();
  assert.equal(live.isCurrent(), true);
});

test('faces that change during a build are built, although no vertex has moved', async () => {
  /** Corners of the meshes that were built. */
  const built: number[] = [];
  /** Called when a build has begun. */
  let begun = () => {};
  const jobs = jobsThat((_, shape) => {
    if (shape) built.push(shape.indices.length);
    begun();
  });
  const positions = Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
  const mesh = (generation: number, offsets: number[], indices: number[]) => ({
    ...{ generation, positions },
    connectivity: {
      ...triangle,
      faceOffsets: Uint32Array.from(offsets),
      faceIndices: Uint32Array.from(indices),
    },
  });
  const state = {
    ...{ model: { faces: 1, vertices: 4 }, dragged: [], running: false },
    document: { ...DOCUMENT },
  };
  const solver = { geometry: mesh(1, [0, 3, 6], [0, 1, 2, 0, 2, 3]) };
  const app = { store: { get: () => state }, solver, actions, jobs } as unknown as AppContext;
  const live = new LiveBuild(app, 'panel', {
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
  const jobs = jobsThat((name, shape) => asked.push(shape?.positions[0] ?? name));
  const connectivity = triangle;
  const positions = Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0);
  const state = {
    ...{ model: { faces: 1, vertices: 100_000 }, dragged: [], running: false },
    document: { ...DOCUMENT },
  };
  const geometry = { generation: 1, positions, connectivity };
  const app = {
    ...{ store: { get: () => state }, solver: { geometry }, actions, jobs },
  } as unknown as AppContext;
  const refuse = (why: string) => assert.fail(why);
  const live = new LiveBuild(app, 'panel', { show() {}, showOffset() {}, refuse });
  await live.offers();
  await live.update();
  state.running = true;
  positions[0] = 7;
  geometry.generation = 2;
  await live.update();
  assert.deepEqual(asked.splice(0), ['buildOffers', 0]);
  await live.zip();
  await live.spatialParts();
  positions[0] = 8;
  geometry.generation = 3;
  await live.reportPage({ title: '', camera: null, link: '' });
  assert.deepEqual(asked, [7, 'zipParts', 'spatialParts', 8, 'reportPage']);
});

test('another shape is built, even one with equal sums of its coordinates', async () => {
  /** The first coordinate of each shape that was built. */
  const built: number[] = [];
  const jobs = jobsThat((_, shape) => {
    if (shape) built.push(shape.positions[0]);
  });
  const connectivity = triangle;
  const shape = (generation: number, ...positions: number[]) => ({
    ...{ generation, connectivity, positions: Float64Array.from(positions) },
  });
  const state = {
    ...{ model: { faces: 1, vertices: 3 }, dragged: [], running: false },
    document: { ...DOCUMENT },
  };
  const solver = { geometry: shape(1, 1, 0, 0, 0, 1, 0, 0, 5, 0) };
  const app = { store: { get: () => state }, solver, actions, jobs } as unknown as AppContext;
  const refuse = (why: string) => assert.fail(why);
  const live = new LiveBuild(app, 'panel', { show() {}, showOffset() {}, refuse });
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
  const jobs = jobsThat((name, shape) => asked.push(shape?.settings.scale ?? name));
  // The solver answers an edit later.
  const settled = async () => {
    await new Promise((done) => setTimeout(done, 5));
    state.document = { ...DOCUMENT, build: { scale: 20 } };
  };
  const { state, live } = withTriangle({ jobs, actions: { settled } });
  state.document.build = { scale: 10 };
  await live.offers();
  await live.update();
  await live.zip();
  assert.deepEqual(asked, ['buildOffers', 10, 20, 'zipParts']);
});

test('what is saved after the worker was replaced is built again', async () => {
  // The archive used to be empty: the new worker had no parts.
  const asked: string[] = [];
  const jobs = jobsThat((name) => asked.push(name));
  const { live } = withTriangle({ jobs });
  await live.offers();
  await live.zip();
  jobs.generation += 1;
  await live.zip();
  assert.deepEqual(asked, ['buildOffers', 'build', 'zipParts', 'build', 'zipParts']);
});

test('what is saved while its build is cancelled is not saved', async () => {
  // An archive without files was saved.
  const asked: string[] = [];
  const jobs = jobsThat((name) => asked.push(name));
  const cancelled = {
    generation: 0,
    ask: calling((name, given) => {
      if (name === 'build') return Promise.reject(new Cancelled());
      return (jobs.ask as unknown as Record<string, (...given: unknown[]) => unknown>)[name](
        ...given,
      );
    }),
  };
  const refused: string[] = [];
  const { live } = withTriangle({ jobs: cancelled }, (why) => refused.push(why));
  await live.offers();
  await assert.rejects(live.zip(), Cancelled);
  assert.deepEqual(refused, ['Cancelled.']);
  assert.deepEqual(asked, ['buildOffers']);
});

test('a build that ends with the worker of another job is begun again', async () => {
  // “Cancelled.” was shown in place of the parts.
  const asked: string[] = [];
  const jobs = {
    generation: 0,
    ask: calling((name) => {
      asked.push(name);
      if (name === 'buildOffers') return Promise.resolve({ presets: [], defaults: {} });
      if (jobs.generation > 0) return Promise.resolve({});
      jobs.generation += 1;
      return Promise.reject(new Cancelled(false));
    }),
  };
  const { live } = withTriangle({ jobs });
  await live.offers();
  await live.update();
  assert.deepEqual(asked, ['buildOffers', 'build', 'build']);
});

test('what is asked about a build that ended with the worker of another job is asked again', async () => {
  // A lesson had no numbers of the parts, the offset did not follow its slider, and nothing was said.
  const asked: string[] = [];
  /** Whether another job is cancelled meanwhile. */
  let isEnding = false;
  const jobs = {
    generation: 0,
    ask: calling((name) => {
      asked.push(name);
      if (name === 'buildOffers') return Promise.resolve({ presets: [], defaults: {} });
      if (!isEnding) return Promise.resolve({});
      isEnding = false;
      jobs.generation += 1;
      return Promise.reject(new Cancelled(false));
    }),
  };
  const { live } = withTriangle({ jobs });
  await live.offers();
  await live.update();
  for (const ask of [() => live.numbers(), () => live.choices(), () => live.moveLayer(1)]) {
    isEnding = true;
    await ask();
  }
  assert.deepEqual(asked, [
    ...['buildOffers', 'build'],
    ...['buildNumbers', 'offsetChoices', 'moveLayer'].flatMap((name) => [name, 'build', name]),
  ]);
});

test('a build is told of guessed positions, of faces left as they are, of the unit and of what holds', async () => {
  const built: Shape[] = [];
  const jobs = jobsThat((_, shape) => {
    if (shape) built.push(shape);
  });
  const connectivity = {
    ...triangle,
    ...{
      untouchedOffsets: Uint32Array.of(0, 3, 5),
      untouchedIndices: Uint32Array.of(5, 6, 7, 8, 9),
    },
    unplaced: Uint32Array.of(1),
  };
  const geometry = { generation: 1, positions: new Float64Array(9), connectivity };
  const { state, live } = withTriangle({ jobs, solver: { geometry } });
  // Not taken for metres: the build refuses it.
  state.document.units = 'inches';
  state.document.handles = [true, false].map((fixed, vertex) => ({ vertex, fixed }));
  await live.offers();
  await live.update();
  const [{ site, offsets, indices, unplaced, untouched }] = built;
  // The faces that are left as they are come last.
  assert.deepEqual(
    [[...offsets], [...indices]],
    [
      [0, 3, 6, 8],
      [0, 1, 2, 5, 6, 7, 8, 9],
    ],
  );
  assert.deepEqual(site, { symbol: 'inches', z_up: true, held: [0] });
  assert.deepEqual([[...unplaced], untouched], [[1], 2]);
});
