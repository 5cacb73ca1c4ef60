// Where sentences may be broken into lines.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { unbroken } from '../../../www/ui/unbroken.ts';

test('a number and its unit stay together', () => {
  // On a narrow card "Worst 0" ended a line, and "mm" began the next one.
  assert.equal(
    unbroken('Worst 0 mm. Moved 1.48 m, 12 ft'),
    'Worst 0\u00a0mm. Moved 1.48\u00a0m, 12\u00a0ft',
  );
  assert.equal(unbroken('All 871 panels moved 3 more'), 'All 871 panels moved 3 more');
});
