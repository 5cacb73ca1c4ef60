// The panel of variations, opened and closed.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { keptShapes } from '../../../www/features/variations/kept-shapes.ts';
import { Variations } from '../../../www/features/variations/variations.ts';
import { Cancelled } from '../../../www/solver/errors.ts';
import { calling } from '../../../www/solver/remote.ts';
import { createStore, type State } from '../../../www/store/state.ts';
import type { AppContext } from '../../../www/app/context.ts';
import type { VariantRow } from '../../../www/pkg/engine/shape_up.js';

test('a panel that is closed while it is being opened leaves no subscription', async () => {
  const store = createStore();
  let subscriptions = 0;
  const counted = {
    ...store,
    subscribe: (...what: Parameters<typeof store.subscribe>) => {
      const stop = store.subscribe(...what);
      subscriptions++;
      return () => {
        subscriptions--;
        stop();
      };
    },
  };
  const variations = new Variations({ store: counted } as unknown as AppContext);
  // Nothing is open: the panel is closed. As an effect of a component, it then ends what it has begun.
  // It was told before there was anything to end.
  let stop: (() => void) | null = null;
  let isClosed = false;
  stop = variations.begin(() => {
    isClosed = true;
    stop?.();
  });
  await Promise.resolve();
  assert.equal(isClosed, true);
  assert.equal(subscriptions, 0);
});

test('variations that ended with the worker of another job are searched again when a slider moves', async () => {
  const store = createStore();
  const asked: string[] = [];
  let left = 0;
  const asks = {
    ask: calling(async (name) => {
      asked.push(name);
      if (name === 'variation') return new Float32Array(9);
      // The ranges are found after the variations.
      if (name === 'advanceVariations')
        return { found: 1, slide: 1, ranges: [null], more: --left > 0 };
      jobs.generation += 1;
      throw new Cancelled(false);
    }),
    copy: () => ({ findVariations: async () => true }),
  };
  const jobs = { generation: 0, of: () => asks };
  const actions = {
    variations: { leave: async () => {} },
    atRest: async () => ({ generation: 1 }),
    reportErrors: (promise: Promise<unknown>) => promise.catch(() => undefined),
  };
  const solver = { geometry: { connectivity: {}, positions: new Float64Array(9) } };
  const app = { store, jobs, actions, solver } as unknown as AppContext;
  store.set({ model: { faces: 1 } as State['model'], document: {} as State['document'] });
  const variations = new Variations(app);
  const stop = variations.begin(assert.fail);
  const settled = () => new Promise((done) => setTimeout(done, 100));
  await settled();
  for (const show of [() => variations.move(0, 50), () => variations.release()]) {
    asked.length = 0;
    left = 3;
    show();
    await settled();
    // The sliders used to do nothing until the next move, and then nothing at all: the search waited for
    // the update that waited for it.
    const again = ['advanceVariations', 'variation', 'advanceVariations', 'advanceVariations'];
    assert.deepEqual(asked.slice(1), again);
    assert.equal(variations.found.value.length, 1);
  }
  stop();
});

test('sliders that are back in the middle show no variation', async () => {
  const shown: string[] = [];
  const variations = {
    leave: async () => void shown.push('left'),
    show: async () => Boolean(shown.push('shown')),
  };
  const actions = { variations, reportErrors: (promise: Promise<unknown>) => promise };
  // The farthest that the constraints allow is the middle itself.
  const go = async () => ({ positions: [], part: 0.001, report: {} });
  const jobs = { generation: 0, of: () => ({ ask: { go, towards: async () => [] } }) };
  const panel = new Variations({ jobs, actions } as unknown as AppContext);
  panel.found.value = [{ slide: 1 } as (typeof panel.found.value)[number]];
  panel.steps.value = [0];
  const done = () => new Promise((end) => setTimeout(end, 5));
  panel.move(0, 3);
  await done();
  panel.move(0, 0);
  await done();
  panel.release();
  await done();
  assert.deepEqual(shown, ['shown', 'left', 'shown', 'left']);
  panel.move(0, 3);
  await done();
  panel.release();
  await done();
  assert.deepEqual(shown.slice(4), ['shown', 'shown', 'left']);
  assert.equal(panel.isExact.value, false);
});

test('where nothing is required, no run is asked for', async () => {
  const store = createStore();
  const copy = () => ({ findVariations: async () => false });
  let freed = 0;
  const ask = { free: async () => ++freed };
  const jobs = { generation: 0, of: () => ({ copy, ask }) };
  const actions = { variations: { leave: async () => {} }, atRest: async () => ({}) };
  const solver = { geometry: { connectivity: {} } };
  const app = { store, jobs, actions, solver } as unknown as AppContext;
  const row = { enabled: true, require: 'exact' };
  const saidWith = async (...constraints: object[]) => {
    store.set({ model: { faces: 1 }, document: { constraints } } as unknown as Partial<State>);
    const variations = new Variations(app);
    const stop = variations.begin(assert.fail);
    await new Promise((done) => setTimeout(done, 5));
    stop();
    assert.ok(freed-- > 0, 'its copy of the model stayed for the rest of the visit');
    return variations.words.value;
  };
  assert.match(await saidWith(row), /Press Run first/);
  assert.match(await saidWith({ ...row, enabled: false }), /nothing is required now/);
});

test('a kept shape is asked for once, and again only under a name that another one has', async () => {
  // Each change of the document fetched and drew all of them.
  const asked: number[] = [];
  const shapesOf = keptShapes({
    variantPositions: async (index) => {
      asked.push(index);
      return new Float64Array(3);
    },
  });
  const row = (name: string, max: number) =>
    ({ name, moved: { max, mean: 0 }, area: 1 }) as VariantRow;
  const [start] = await shapesOf([row('Start', 0), row('Variation 1', 2)]);
  assert.equal((await shapesOf([row('Start', 0), row('Variation 1', 2)]))[0], start);
  assert.deepEqual(asked.splice(0), [0, 1]);
  await shapesOf([row('Start', 0), row('Variation 1', 3)]);
  assert.deepEqual(asked.splice(0), [1]);
  // By symmetry a shape can have the name and the numbers of the one that it came after.
  await shapesOf([row('Start', 0)]);
  const twice = [row('Start', 0), row('Variation 1', 3), row('Variation 1', 3)];
  assert.equal((await shapesOf(twice)).length, 3);
  assert.deepEqual(asked, [1, 2]);
});
