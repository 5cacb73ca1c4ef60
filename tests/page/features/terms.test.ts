// The words with a meaning of their own: one list, in the documentation of the crate and in the help.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { TERMS } from '../../../www/features/help/terms.ts';

test('the terms of the help are those of the crate', async () => {
  const text = await readFile(new URL('../../../src/lib.rs', import.meta.url), 'utf8');
  const [, table = ''] = /^\/\/! # Terms\n([^#]*)/m.exec(text) ?? [];
  const rows = [...table.matchAll(/^\/\/! \| ([^|]+) \| ([^|]+) \|$/gm)];
  // What the code calls it follows its name.
  const known = new Map(
    rows.map(([, term, meaning]) => [term.split(', in the code ')[0], meaning]),
  );
  assert.ok(known.size > 9);
  for (const [term, meaning] of TERMS) assert.equal(known.get(term), meaning, term);
  for (const term of ['panel', 'original', 'handle', 'fixed', 'tolerance', 'relaxed tolerance'])
    assert.ok(
      TERMS.some(([one]) => one === term),
      term,
    );
  for (const term of ['satisfied', 'estimate', 'suggestion'])
    assert.ok(
      TERMS.some(([one]) => one === term),
      term,
    );
});
