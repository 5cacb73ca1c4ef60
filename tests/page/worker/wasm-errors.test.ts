// Which errors leave the solver's module unusable.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isTrap } from '../../../www/solver/errors.ts';

/** A module whose only function, f, calls itself. */
const recursive = new Uint8Array([
  ...[0, 97, 115, 109, 1, 0, 0, 0],
  ...[1, 4, 1, 96, 0, 0],
  ...[3, 2, 1, 0],
  ...[7, 5, 1, 1, 102, 0, 0],
  // The call is not the last instruction, or it could become a loop.
  ...[10, 8, 1, 6, 0, 16, 0, 16, 0, 11],
]);

test('only an error thrown inside wasm counts as a trap', () => {
  const thrownBy = (action: () => unknown) => {
    try {
      action();
    } catch (thrown) {
      return thrown;
    }
    return undefined;
  };
  const { exports } = new WebAssembly.Instance(new WebAssembly.Module(recursive));
  const f = exports.f as () => void;
  assert.equal(isTrap(thrownBy(() => f())), true);
  const many = new Array(1_000_000).fill(0);
  assert.equal(isTrap(thrownBy(() => ([] as number[]).push(...many))), false);
  assert.equal(isTrap(new RangeError('Maximum call stack size exceeded')), false);
  assert.equal(isTrap(new WebAssembly.RuntimeError('unreachable')), true);
});
