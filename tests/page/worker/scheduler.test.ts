// How a run divides the worker's time between iterations and the frames sent to the page, and what
// the page is told.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Solver } from '../../../www/pkg/engine/shape_up.js';
import type { FromWorker } from '../../../www/solver/events.ts';
import { Scheduler, SLICE_MS } from '../../../www/worker/scheduler.ts';
import { closeChannel, died, solverWith } from './fake-solver.ts';

/** A clock that advances only when the test does work. */
function clock() {
  let now = 0;
  return { now: () => now, pass: (ms: number) => (now += ms) };
}

test('a run spends most of its time on iterations, however long a frame takes', async (context) => {
  // Frames used to be sent whenever the page returned a buffer: colours that took as long as an
  // iteration halved the number of iterations, because the time of those frames was not counted.
  const time = clock();
  context.mock.method(performance, 'now', time.now);
  closeChannel(context);
  const [ITERATION, COLOURS, ITERATIONS] = [40, 40, 120];
  let [iterations, coloured] = [0, 0];
  const solver = solverWith({
    step() {
      time.pass(ITERATION);
      return ++iterations === ITERATIONS;
    },
    faceValues() {
      time.pass(COLOURS);
      coloured += 1;
      return { values: new Float32Array(1), greatest: 0 };
    },
  });
  let ended = () => {};
  const end = new Promise<void>((resolve) => (ended = resolve));
  const scheduler = new Scheduler(
    solver,
    (message) => {
      // A fast page, which returns each buffer at once.
      if (message.type === 'frame') {
        queueMicrotask(() => {
          scheduler.frames.takeBack(message.positions);
          scheduler.sendFrame();
        });
      }
      if (message.type === 'activity' && !message.running) ended();
    },
    died,
  );
  scheduler.begin(false);
  scheduler.frames.renew(3);
  scheduler.frames.shown = {
    measure: 'surface',
    shapes: false,
    projections: false,
    corners: false,
  };
  scheduler.run();
  await end;
  const part = (coloured * COLOURS) / (coloured * COLOURS + iterations * ITERATION);
  assert.ok(coloured > 10, `${coloured} frames`);
  assert.ok(part < 0.3, `frames take ${part} of the time`);
});

test('a run sends its progress, however the one before ended', async (context) => {
  const time = clock();
  context.mock.method(performance, 'now', time.now);
  closeChannel(context);
  context.mock.timers.enable({ apis: ['setTimeout'] });
  const sent: FromWorker['type'][] = [];
  const post = ({ type }: FromWorker) => sent.push(type);
  let steps = 0;
  const step = () => {
    time.pass(SLICE_MS);
    steps += 1;
    return false;
  };
  const scheduler = new Scheduler(solverWith({ step }), post, died);
  scheduler.begin(false);
  scheduler.frames.renew(3);
  // The first one ends before its progress is due.
  for (const due of [0, 60_000]) {
    scheduler.run();
    for (const before = steps; steps === before;) await new Promise((done) => setImmediate(done));
    context.mock.timers.tick(due);
    scheduler.pause();
  }
  assert.ok(sent.includes('progress'), `${sent}`);
});

test('a file that is refused during a run leaves the page with the ended run', (context) => {
  closeChannel(context);
  const sent: { type: string; running?: boolean }[] = [];
  const scheduler = new Scheduler(solverWith({}), (message) => sent.push(message), died);
  scheduler.begin(false);
  scheduler.frames.renew(3);
  scheduler.run();
  assert.equal(sent.at(-1)?.running, true);
  const refuse = () => {
    throw new Error('it is no mesh');
  };
  assert.throws(() => scheduler.replace(refuse), /it is no mesh/);
  assert.deepEqual(sent.at(-1), { type: 'activity', running: false, converged: false });
});

test('an edit that is refused, or changes nothing, does not begin a run anew', (context) => {
  closeChannel(context);
  let isRunning = false;
  let begun = 0;
  const solver = solverWith({
    isRunning: () => isRunning,
    beginRun() {
      isRunning = true;
      begun += 1;
    },
  });
  const scheduler = new Scheduler(solver, () => {}, died);
  scheduler.begin(false);
  scheduler.frames.renew(3);
  scheduler.run();
  const refuse = () => {
    throw new Error('expected a number');
  };
  assert.throws(() => scheduler.betweenRuns(refuse), /expected a number/);
  scheduler.betweenRuns(() => false);
  assert.equal(begun, 1);
  // The solver ends it for what has an effect.
  scheduler.betweenRuns(() => {
    isRunning = false;
    return true;
  });
  assert.equal(begun, 2);
});

test('the page gets the shape that an edit leaves that is refused only after it has changed', (context) => {
  // It went on showing a variation that the solver had left.
  closeChannel(context);
  let generation = 2;
  const sent: FromWorker['type'][] = [];
  const solver = solverWith({ generation: () => generation });
  const scheduler = new Scheduler(solver, ({ type }) => sent.push(type), died);
  scheduler.begin(false);
  scheduler.frames.renew(3);
  const documents = () => sent.filter((type) => type === 'document').length;
  const before = documents();
  const refuse = () => {
    throw new Error('it is no mesh');
  };
  assert.throws(() => scheduler.betweenRuns(refuse), /it is no mesh/);
  assert.equal(documents(), before);
  const leave = () => {
    generation = 1;
    refuse();
  };
  assert.throws(() => scheduler.betweenRuns(leave), /it is no mesh/);
  assert.equal(documents(), before + 1);
});

test('steps that may take seconds are announced as work, so that the worker is not given up', async (context) => {
  const time = clock();
  context.mock.method(performance, 'now', time.now);
  closeChannel(context);
  const sent: FromWorker['type'][] = [];
  const post = ({ type }: FromWorker) => sent.push(type);
  // The last message before each step.
  const before: (FromWorker['type'] | undefined)[] = [];
  let ended = () => {};
  const end = new Promise<void>((resolve) => (ended = resolve));
  const solver = solverWith({
    // The first two of five steps iterate, and the others meet hard constraints.
    isMeeting: () => before.length >= 2,
    step() {
      time.pass(SLICE_MS);
      return before.push(sent.at(-1)) === 5;
    },
    endRun() {
      ended();
      return undefined;
    },
  });
  const scheduler = new Scheduler(solver, post, died);
  scheduler.begin(false);
  scheduler.run();
  await end;
  // The first step may have to factor the system.
  assert.deepEqual(before, ['working', 'pong', 'working', 'working', 'working']);
});

test('a refused edit that was to run leaves a run under way', (context) => {
  // The solver had ended it, and the page showed a run that was none.
  closeChannel(context);
  const sent: { type: string; running?: boolean }[] = [];
  let runs = 0;
  let isRunning = false;
  const solver = solverWith({
    beginRun() {
      runs += 1;
      isRunning = true;
    },
    isRunning: () => isRunning,
    editAndRun() {
      isRunning = false;
      throw new Error('no length');
    },
  });
  const scheduler = new Scheduler(solver, (message) => sent.push(message), died);
  scheduler.begin(false);
  scheduler.frames.renew(3);
  const refused = () => scheduler.runFor(() => solver.editAndRun('reset'));
  // Without a run there is none to go on with.
  assert.throws(refused, /no length/);
  assert.deepEqual([runs, scheduler.isIterating], [0, false]);
  scheduler.run();
  sent.length = 0;
  assert.throws(refused, /no length/);
  assert.deepEqual([runs, isRunning, scheduler.isIterating], [2, true, true]);
  assert.deepEqual(sent, []);
});

test('after a trap nothing more is asked of the solver, whose refusals would hide it', (context) => {
  // An edit that trapped during a run was told as "recursive use of an object", and the dead solver
  // was not replaced.
  closeChannel(context);
  let isDead = false;
  const refuse = () => {
    if (isDead) throw new Error('recursive use of an object');
    return true;
  };
  const trap = () => {
    isDead = true;
    throw new WebAssembly.RuntimeError('unreachable');
  };
  const others = { isRunning: refuse, beginRun: refuse, endRun: refuse as never, step: trap };
  const scheduler = new Scheduler(solverWith(others), () => {}, died);
  scheduler.begin(false);
  for (const performs of [
    () => scheduler.betweenRuns(trap),
    () => scheduler.runFor(trap),
    () => scheduler.replace(trap),
    // A first model, solved before it is shown.
    () => scheduler.begin(true),
  ]) {
    isDead = false;
    scheduler.run();
    assert.throws(performs, WebAssembly.RuntimeError);
  }
});

test('the collapse that has ended a run is told after its last frame and its end', async (context) => {
  // The status line said "Stopped after 12 iterations" instead of why, when a buffer was not free.
  closeChannel(context);
  const sent: FromWorker['type'][] = [];
  const frames: Float64Array[] = [];
  let ended = () => {};
  const end = new Promise<void>((resolve) => (ended = resolve));
  const solver = solverWith({
    step: () => true,
    collapse: () => 'the mesh collapsed',
    endRun() {
      ended();
      return 'the mesh collapsed';
    },
  });
  const scheduler = new Scheduler(
    solver,
    (message) => {
      sent.push(message.type);
      if (message.type === 'frame') frames.push(message.positions);
    },
    died,
  );
  scheduler.begin(false);
  scheduler.frames.renew(1);
  // The page draws a frame, and has the only free buffer.
  scheduler.changed();
  scheduler.run();
  await end;
  await new Promise((done) => setImmediate(done));
  sent.length = 0;
  scheduler.frames.takeBack(frames[0]);
  scheduler.sendFrame();
  assert.deepEqual(sent, ['frame', 'activity', 'collapsed']);
});

test('the numbers of a step are its answer, also if its frame must wait', (context) => {
  // "Converged after 11 iterations" was said of the twelfth.
  closeChannel(context);
  let iteration = 11;
  const singleStep = () => ++iteration === 12;
  const frame = () => ({ iteration }) as ReturnType<Solver['frame']>;
  const scheduler = new Scheduler(solverWith({ singleStep, frame }), () => {}, died);
  scheduler.begin(false);
  scheduler.frames.renew(1);
  scheduler.changed();
  assert.equal(scheduler.step().iteration, 12);
});

test('a collapse by single steps is told when it comes', (context) => {
  // It was asked about at an export only.
  closeChannel(context);
  let steps = 0;
  const told: number[] = [];
  const solver = solverWith({
    singleStep: () => ++steps > 9,
    collapse: () => (steps > 1 ? 'the mesh collapsed' : undefined),
  });
  const post = ({ type }: FromWorker) => type === 'collapsed' && told.push(steps);
  const scheduler = new Scheduler(solver, post, died);
  scheduler.begin(false);
  for (let step = 0; step < 3; step++) {
    scheduler.frames.renew(1);
    scheduler.step();
  }
  assert.deepEqual(told, [2]);
});

/** Whether the page is told that the shape has converged, after each of some actions. */
async function convergedAfter(solver: Partial<Solver>, ...acts: ((to: Scheduler) => unknown)[]) {
  let converged: boolean | undefined;
  const scheduler = new Scheduler(
    solverWith(solver),
    (message) => {
      if (message.type === 'activity') ({ converged } = message);
      if (message.type === 'frame')
        queueMicrotask(() => scheduler.frames.takeBack(message.positions));
    },
    died,
  );
  scheduler.begin(false);
  scheduler.frames.renew(1);
  const told = [];
  for (const act of acts) {
    act(scheduler);
    await new Promise((done) => setImmediate(done));
    told.push(converged);
  }
  return told;
}

test('what was refused without an error leaves a converged shape converged', async (context) => {
  // "Next: Run" was said after Make exact while a variation was shown.
  closeChannel(context);
  const solver = { singleStep: () => true, generation: () => 1 };
  const told = await convergedAfter(
    solver,
    (to) => to.step(),
    (to) => to.betweenRuns(() => false, true),
    (to) => to.betweenRuns(() => false, false),
    (to) => to.betweenRuns(() => true, true),
    (to) => to.betweenRuns(() => true, false),
  );
  assert.deepEqual(told, [true, true, true, true, false]);
});

test('a shape at which an iteration failed has not converged, whatever follows', async (context) => {
  // It had with the next edit that leaves the shape, as a name.
  closeChannel(context);
  const step = () => {
    throw new Error('the system is singular');
  };
  const told = await convergedAfter(
    { step, generation: () => 1 },
    (to) => to.run(),
    (to) => to.betweenRuns(() => null),
  );
  assert.deepEqual(told, [false, false]);
});

test('an iteration that failed ends the run in the solver too, and the page gets its scene', async (context) => {
  // Its step of undo stayed open, and the saved scene was that of before the run.
  closeChannel(context);
  let isRunning = false;
  const sent: FromWorker['type'][] = [];
  const solver = solverWith({
    beginRun: () => void (isRunning = true),
    isRunning: () => isRunning,
    endRun: () => void (isRunning = false),
    step() {
      throw new Error('the system is singular');
    },
  });
  const scheduler = new Scheduler(solver, ({ type }) => sent.push(type), died);
  scheduler.begin(false);
  scheduler.frames.renew(1);
  scheduler.run();
  sent.length = 0;
  await new Promise((done) => setImmediate(done));
  assert.equal(isRunning, false);
  const expected = [
    'working',
    'trouble',
    'activity',
    'scene',
    'document',
    'frame',
    'activity',
    'pong',
  ];
  assert.deepEqual(sent, expected);
});
