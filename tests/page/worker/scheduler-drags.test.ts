// What a drag, and what is asked for during one, leave of each other.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { FromWorker } from '../../../www/solver/events.ts';
import type { Drag } from '../../../www/solver/types.ts';
import { Scheduler } from '../../../www/worker/scheduler.ts';
import { closeChannel, died, solverWith } from './fake-solver.ts';

/** Moves vertex 0 to a place on the x axis, in the phases of the drag with this number. */
const dragsOf = (scheduler: Scheduler, id: number) => (phase: Drag['phase'], x: number) =>
  scheduler.drag({ id, vertices: Uint32Array.of(0), targets: Float64Array.of(x, 0, 0), phase });

/** A scheduler during a drag that has moved vertex 0, with the types of what it sends. */
function dragged(solver: ConstructorParameters<typeof Scheduler>[0], sent: FromWorker['type'][]) {
  const scheduler = new Scheduler(solver, ({ type }) => sent.push(type), died);
  scheduler.begin(false);
  scheduler.frames.renew(1);
  const drag = dragsOf(scheduler, 1);
  drag('start', 0);
  drag('move', 1);
  return { scheduler, drag };
}

test('a refused drag leaves the run and the document as they were', (context) => {
  // It used to end the run, and its end was not answered, so that the page kept the dragged target.
  closeChannel(context);
  const sent: { type: string; running?: boolean }[] = [];
  const phases: string[] = [];
  const drag = (_vertices: Uint32Array, _targets: Float64Array, phase: string) => {
    phases.push(phase);
    if (phase === 'start') throw new Error('locked by the lesson');
  };
  const solver = solverWith({ drag, isRunning: () => true });
  const scheduler = new Scheduler(solver, (message) => sent.push(message), died);
  scheduler.begin(false);
  scheduler.frames.renew(3);
  scheduler.run();
  sent.length = 0;
  const drags = (phase: 'start' | 'move' | 'end') =>
    scheduler.guard(() =>
      scheduler.drag({ id: 1, vertices: new Uint32Array(1), targets: new Float64Array(3), phase }),
    );
  drags('start');
  const refused = { type: 'trouble', message: 'locked by the lesson' };
  const shown = { type: 'document', document: undefined };
  assert.deepEqual(sent.splice(0), [refused, { type: 'dragEnded', id: 1 }, shown]);
  drags('move');
  drags('end');
  assert.deepEqual([phases, sent], [['start'], []]);
  assert.equal(scheduler.isIterating, true);
});

test('an edit during a drag acts on its latest move, and ends it', (context) => {
  // A target that was typed is a short drag: Undo at once undid the step before it, and the move came
  // to nothing.
  closeChannel(context);
  const calls: string[] = [];
  const solver = solverWith({
    drag: (_, targets, phase) => void calls.push(`${phase} ${targets}`),
    undo: () => void calls.push('undo'),
    generation: () => 1,
  });
  const sent: FromWorker['type'][] = [];
  const { scheduler, drag } = dragged(solver, sent);
  scheduler.betweenRuns(() => solver.undo());
  // Nothing is left of it where the edit had no effect.
  const expected = ['start 0,0,0', 'move 1,0,0', 'undo', 'end '];
  assert.deepEqual(calls, expected);
  assert.equal(scheduler.isMoving, false);
  // The page is told before it has the document.
  assert.deepEqual(
    sent.filter((type) => ['dragEnded', 'document'].includes(type)),
    ['dragEnded', 'document'],
  );
  // What the page still sends of it moves nothing.
  drag('move', 2);
  drag('end', 2);
  assert.deepEqual(calls, expected);
});

test('a refused edit leaves a drag as it was, and another drag does not touch it', (context) => {
  // Its end put the handle back where it was before the drag.
  closeChannel(context);
  const calls: string[] = [];
  const solver = solverWith({
    drag: (_, targets, phase) => void calls.push(`${phase} ${targets}`),
  });
  const scheduler = new Scheduler(solver, () => {}, died);
  scheduler.begin(false);
  scheduler.frames.renew(1);
  const [own, other] = [2, 1].map((id) => dragsOf(scheduler, id));
  own('start', 0);
  assert.throws(() =>
    scheduler.betweenRuns(() => {
      throw new Error('locked by the lesson');
    }),
  );
  for (const phase of ['move', 'end', 'cancel'] as const) other(phase, 7);
  assert.equal(scheduler.isMoving, true);
  own('end', 1);
  assert.deepEqual(calls, ['start 0,0,0', 'end 1,0,0']);
});

test('a half step during a drag ends it with its latest move', (context) => {
  // The solver had ended it, and every later move was lost, while the mesh went on by itself.
  closeChannel(context);
  const calls: string[] = [];
  const sent: FromWorker['type'][] = [];
  const solver = solverWith({
    drag: (_, targets, phase) => void calls.push(`${phase} ${targets}`),
    halfStep() {
      calls.push('half');
      return { half: 'local', fitted: [] };
    },
  });
  const { scheduler } = dragged(solver, sent);
  scheduler.halfStep();
  assert.deepEqual(calls, ['start 0,0,0', 'move 1,0,0', 'half', 'end ']);
  // It is a step of undo now.
  assert.ok(sent.includes('document'));
  assert.equal(scheduler.isMoving, false);
});
