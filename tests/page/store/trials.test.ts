// Trials on a copy of the model: what ends them, and what of them is kept.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createTrials } from '../../../www/store/trials.ts';
import { Cancelled } from '../../../www/solver/errors.ts';
import { Emitter } from '../../../www/solver/emitter.ts';
import type { JobsClient } from '../../../www/solver/jobs-client.ts';
import type { SolverClient } from '../../../www/solver/solver-client.ts';

type Heard = { frame: { generation: number }; scene: { generation: number } };
type Fake = Emitter<Heard>;

/** What each trial finds. */
const FOUND = { offer: 'the cost', shape: 'the shape', positions: [] };

/**
 * Trials of many steps; `during` is called after the first.
 * @param scene the generation of the scene, if its frame is still to come
 */
function trials(during: (solver: Fake) => void, scene = 5) {
  const solver = Object.assign(new Emitter<Heard>(), {
    copy: () => ({ text: 'the scene', generation: 5 }),
  });
  let steps = 0;
  const freed: string[] = [];
  const begun: unknown[] = [];
  /** What the worker has been asked to try last. */
  let last = '';
  const copy = (model: unknown) => {
    const begin = (name: string) => async () => {
      begun.push(model);
      last = name;
    };
    return {
      tryExact: begin('exact'),
      tryImprovement: begin('improvement'),
      trySuggestions: begin('suggestions'),
      tryPresses: begin('presses'),
    };
  };
  const ask = {
    async advance() {
      if (++steps === 1) during(solver);
      return steps < 9;
    },
    offer: async () => (/exact|improvement/.test(last) ? FOUND.offer : null),
    shape: async () => FOUND.shape,
    positions: async () => FOUND.positions,
    suggestions: async () => ['smooth less'],
    betterPresses: async () => (steps > 3 ? ['within 50 mm'] : []),
    free: async () => void freed.push(last),
  };
  const made = createTrials(
    solver as unknown as SolverClient,
    { of: () => ({ ask, copy }) } as unknown as JobsClient,
  );
  solver.emit('frame', { generation: 5 });
  solver.emit('scene', { generation: scene });
  return { made, begun, freed, steps: () => steps };
}

test('a trial runs to its end on a copy of the model', async () => {
  const { made, begun, steps } = trials((solver) => {
    solver.emit('scene', { generation: 5 });
    solver.emit('frame', { generation: 5 });
  });
  assert.deepEqual(await made.exactOffer(() => true), FOUND);
  assert.deepEqual(begun, [{ text: 'the scene', generation: 5 }]);
  assert.equal(steps(), 9, 'a setting of the build changes neither problem nor shape');
});

test('a trial that begins with a scene goes on when the frame of that comes', async () => {
  const { made, steps } = trials((solver) => solver.emit('frame', { generation: 6 }), 6);
  assert.deepEqual(await made.exactOffer(() => true), FOUND);
  assert.equal(steps(), 9);
});

test('a trial that waits does not replace what the one before has found until it is read', async () => {
  const { made, begun } = trials(() => void made.betterPresses(() => {}));
  assert.deepEqual(await made.exactOffer(() => true), FOUND);
  await new Promise((done) => setTimeout(done));
  assert.equal(begun.length, 2, 'the other one follows');
});

for (const [what, during] of [
  ['a run or a drag', (solver: Fake) => solver.emit('frame', { generation: 6 })],
  ['an edit', (solver: Fake) => solver.emit('scene', { generation: 6 })],
] as const)
  test(`${what} ends a trial, and what was found is dropped`, async () => {
    const { made, steps, freed } = trials(during);
    assert.equal(await made.exactOffer(() => true), undefined);
    assert.equal(steps(), 1);
    // A session with its factors stayed until there was another trial.
    assert.deepEqual(freed, ['exact']);
    const improving = trials(during);
    assert.equal(await improving.made.improvement(() => true), undefined);
    const helping = trials(during);
    assert.deepEqual(await helping.made.suggestions(), ['smooth less'], 'those found before it');
  });

test('a trial that ends with the worker of another job begins again, and one that is cancelled does not', async () => {
  for (const [isDirect, begins] of [
    [false, 2],
    [true, 1],
  ] as const) {
    let isFirst = true;
    const { made, begun } = trials(() => {
      if (!isFirst) return;
      isFirst = false;
      throw new Cancelled(isDirect);
    });
    const found = made.exactOffer(() => true);
    await (isDirect ? assert.rejects(found, Cancelled) : assert.doesNotReject(found));
    assert.equal(begun.length, begins);
  }
});

test('another trial ends the one before', async () => {
  const { made, freed } = trials(() => {});
  const first = made.exactOffer(() => true);
  const second = made.improvement(() => true);
  assert.deepEqual([await first, await second], [undefined, FOUND]);
  assert.deepEqual(freed, ['improvement'], 'the copy is that of the second');
});

test('an improvement that is stopped keeps what it has', async () => {
  let isStopped = false;
  const { made, steps } = trials(() => (isStopped = true));
  assert.deepEqual(await made.improvement(() => !isStopped), FOUND);
  assert.equal(steps(), 1);
});

test('better presses let other trials go first, and begin again after them', async () => {
  const { made, begun, steps } = trials(() => {});
  const heard: unknown[] = [];
  const pressed = made.betterPresses((presses) => heard.push(...presses));
  assert.deepEqual(await made.exactOffer(() => true), FOUND);
  assert.equal(await pressed, true);
  assert.ok(begun.length >= 2 && steps() >= 9);
  assert.deepEqual(new Set(heard), new Set(['within 50 mm']));
});

test('an edit ends the search for better presses', async () => {
  const { made } = trials((solver) => solver.emit('scene', { generation: 6 }));
  assert.equal(await made.betterPresses(() => {}), false);
});
