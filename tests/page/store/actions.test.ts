// What is asked of the solver once, and when it is asked again.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createActions } from '../../../www/store/actions.ts';
import { Emitter } from '../../../www/solver/emitter.ts';
import { createStore } from '../../../www/store/state.ts';
import type { Alerts } from '../../../www/ui/controls/alerts.ts';
import type { JobsClient } from '../../../www/solver/jobs-client.ts';
import type { SolverClient } from '../../../www/solver/solver-client.ts';

test('the original is asked for once for every model', async () => {
  const solverEvents = new Emitter<{ model: object }>();
  let asked = 0;
  const solver = {
    on: solverEvents.on.bind(solverEvents),
    ask: { originalPositions: async () => ++asked },
    ...{ change: {}, tell: {} },
  } as unknown as SolverClient;
  const { originalPositions } = createActions(
    createStore(),
    solver,
    {} as JobsClient,
    {} as Alerts,
  );
  assert.equal(await originalPositions(), 1);
  assert.equal(await originalPositions(), 1);
  solverEvents.emit('model', {});
  assert.equal(await originalPositions(), 2);
});
