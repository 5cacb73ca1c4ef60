// What is asked of the solver once, and when it is asked again.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createQueries } from '../../../www/store/queries.js';

test('the original is asked for once for every model', async () => {
  const heard = {};
  let asked = 0;
  const solver = /** @type {any} */ ({
    on: (event, hear) => (heard[event] = hear),
    request: async () => ++asked,
  });
  const { originalPositions } = createQueries(solver, (promise) => promise);
  assert.equal(await originalPositions(), 1);
  assert.equal(await originalPositions(), 1);
  heard.model();
  assert.equal(await originalPositions(), 2);
});
