// To which shape the layouts of new panels belong.

import assert from 'node:assert/strict';
import { test, type TestContext } from 'node:test';
import { Layouts } from '../../../www/features/make-panels/layouts.ts';
import { Cancelled } from '../../../www/solver/errors.ts';
import { Emitter } from '../../../www/solver/emitter.ts';
import { createStore, type State } from '../../../www/store/state.ts';
import type { AppContext } from '../../../www/app/context.ts';

/** The parts of the solver that layouts follow. */
class Solver extends Emitter<{ scene: object; frame: object }> {
  generation = 1;

  copy() {
    return { text: '', generation: this.generation };
  }
  scene(generation: number) {
    this.generation = generation;
    this.emit('scene', { generation });
  }
  frame(generation: number) {
    this.emit('frame', { generation });
  }
}

/** Layouts of panels that know for which generation they were laid out. */
async function begun(context: TestContext, boundary: string | null = null) {
  const solver = new Solver();
  let kept: number[] = [];
  const jobs = Object.assign(new Emitter<object>(), {
    cancel() {},
    copy: ({ generation }: { generation: number }) => ({
      layOutPanels: async (_: object, faces: Uint32Array) => {
        kept = [...faces];
        return { words: `for ${generation}`, notes: [], count: 1, size: 1, boundary };
      },
      panelsAtBoundaries: () => Promise.reject(new Cancelled()),
    }),
  });
  const viewport = Object.assign(new Emitter<object>(), { unmeasured() {} });
  const actions = { display() {} };
  const store = createStore();
  const app = { store, solver, jobs, viewport, actions };
  const layouts = new Layouts(app as unknown as AppContext, () => {});
  context.after(layouts.begin());
  await answered();
  return { store, solver, layouts, said: () => layouts.said.value.words, kept: () => kept };
}

const answered = () => new Promise((done) => setTimeout(done));

test('panels for a changed shape stay when the frame with it comes after them', async (context) => {
  // They were for the shape before that frame: the next one removed them, and none came again.
  const { solver, said } = await begun(context);
  assert.equal(said(), 'for 1');
  solver.scene(2);
  await answered();
  assert.equal(said(), 'for 2');
  solver.frame(2);
  // Another measure has a frame, too.
  solver.frame(2);
  await answered();
  assert.equal(said(), 'for 2');
});

test('panels are laid out again in another unit, in which their words are', async (context) => {
  // The card of new panels, its lengths said in the unit that was guessed, stayed for good.
  const { store, solver, layouts } = await begun(context);
  const before = layouts.laidOut.value;
  for (const units of ['m', 'mm']) {
    store.set({ document: { units } as State['document'] });
    solver.scene(1);
    await answered();
  }
  assert.notEqual(layouts.laidOut.value, before);
});

test('the faces that stay are those selected now', async (context) => {
  // They were those that were selected when the card was opened.
  const { store, layouts, kept } = await begun(context);
  const select = (...faces: number[]) =>
    store.set({ selection: { ...store.get().selection, faces: new Set(faces) } });
  layouts.change({ keeps: true });
  await answered();
  assert.deepEqual(kept(), []);
  select(2, 3);
  await answered();
  assert.deepEqual(kept(), [2, 3]);
  select();
  await answered();
  assert.deepEqual(kept(), []);
});

test('a shape that moves removes the panels, and at rest it has some again', async (context) => {
  const { solver, said } = await begun(context);
  for (const generation of [2, 3]) {
    solver.frame(generation);
    await answered();
    assert.equal(said(), 'The shape has changed …');
  }
  solver.scene(4);
  solver.frame(4);
  await answered();
  assert.equal(said(), 'for 4');
});

test('after a shape that was only shown there are panels again', async (context) => {
  const { solver, said } = await begun(context);
  solver.frame(2);
  assert.equal(said(), 'The shape has changed …');
  solver.frame(1);
  await answered();
  assert.equal(said(), 'for 1');
});

test('a comparison at the boundary that is cancelled ends', async (context) => {
  // Its place said … for ever.
  context.mock.timers.enable({ apis: ['setTimeout'] });
  const wait = () => new Promise((done) => setImmediate(done));
  const began = begun(context, 'follow');
  await wait();
  context.mock.timers.tick(0);
  const { layouts } = await began;
  assert.equal(layouts.forecast.value, null);
  context.mock.timers.tick(1000);
  await wait();
  assert.deepEqual(layouts.forecast.value, []);
  assert.equal(layouts.doing.value, null);
});
