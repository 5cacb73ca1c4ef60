// What the tests of the scheduler put in place of a solver.

import assert from 'node:assert/strict';
import type { TestContext } from 'node:test';
import type { Solver } from '../../../www/pkg/engine/shape_up.js';

/** Closes the channel of the scheduler at the end: Node does not exit while one is open. */
export function closeChannel(context: TestContext) {
  const channel = new MessageChannel();
  context.mock.method(globalThis, 'MessageChannel', function () {
    return channel;
  });
  context.after(() => channel.port1.close());
}

/** A solver with these methods; all others do nothing. */
export function solverWith(methods: Partial<Solver>) {
  const all: Record<string | symbol, unknown> = {
    savedHistory: () => new Uint8Array(0),
    savedProgress: () => new Uint8Array(0),
    ...methods,
  };
  const get = (_: object, name: string | symbol) => all[name] ?? (() => undefined);
  return new Proxy(all, { get }) as unknown as Solver;
}

/** The solver does not die in these tests. */
export const died = (thrown: unknown) => assert.fail(thrown as Error);
