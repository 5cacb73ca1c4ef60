// The end of a run that an action begins.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { endOfRun } from '../../../www/store/end-of-run.ts';
import { Emitter } from '../../../www/solver/emitter.ts';
import type { SolverClient } from '../../../www/solver/solver-client.ts';

type Heard = { activity: { running: boolean; converged: boolean }; trouble: object };

function client() {
  const solver = new Emitter<Heard>();
  const tell = (running: boolean) => solver.emit('activity', { running, converged: !running });
  const refuse = () => solver.emit('trouble', {});
  return { solver: solver as unknown as SolverClient, tell, refuse };
}

/** What a promise is by now. */
const now = (promise: Promise<unknown>) => Promise.race([promise, Promise.resolve('under way')]);

test('a run that has ended before its beginning is answered is not missed', async () => {
  // The card of the panels used to show the progress of such a run for ever.
  const { solver, tell } = client();
  const { ended } = endOfRun(solver);
  tell(true);
  tell(false);
  assert.equal(await ended, true);
});

test('the end of the run before is not that of the next one, unless it counts', async () => {
  const { solver, tell } = client();
  const [next, either] = [endOfRun(solver), endOfRun(solver, true)];
  tell(false);
  assert.equal(await now(either.ended), true);
  assert.equal(await now(next.ended), 'under way');
  tell(true);
  tell(false);
  assert.equal(await now(next.ended), true);
});

test('a run that is refused ends where it would have begun', async () => {
  // Refine and solve waited for ever, and the button said Pause.
  const { solver, refuse } = client();
  const { ended } = endOfRun(solver);
  refuse();
  solver.emit('activity', { type: 'activity', running: false, converged: false });
  assert.equal(await ended, false);
});

test('what is no longer waited for does not end', async () => {
  const { solver, tell } = client();
  const { ended, stop } = endOfRun(solver);
  stop();
  tell(true);
  tell(false);
  assert.equal(await now(ended), 'under way');
});
