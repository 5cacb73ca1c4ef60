// Work is skipped only while everything that it depends on is as it was when it was done.

import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { targetFolder } from '../../.scripts/project.mjs';
import { stampOf, unlessUnchanged } from '../../.scripts/stamp.mjs';

mkdirSync(targetFolder, { recursive: true });
const folder = mkdtempSync(join(targetFolder, 'stamp-test-'));
const name = 'stamp-of-the-test';
after(() => {
  rmSync(folder, { recursive: true });
  rmSync(join(targetFolder, 'stamps', name), { force: true });
});

test('a stamp is of the names and contents of all files, and of the settings', () => {
  const file = join(folder, 'a.txt');
  const of = (settings = [1]) => stampOf({ name, inputs: [folder], settings });
  writeFileSync(file, 'one');
  assert.equal(of().stored(), undefined);
  of().store({ passed: 3 });
  assert.deepEqual(of().stored(), { passed: 3 });
  assert.equal(of([2]).stored(), undefined);
  writeFileSync(file, 'two');
  assert.equal(of().stored(), undefined);
  writeFileSync(file, 'one');
  writeFileSync(join(folder, 'b.txt'), '');
  assert.equal(of().stored(), undefined);
});

test('a step that failed, or whose output is gone, runs again', async () => {
  const output = join(folder, 'output');
  let runs = 0;
  const work = { name, inputs: [], output };
  const step = () => {
    runs += 1;
    writeFileSync(output, '');
  };
  await assert.rejects(
    unlessUnchanged(work, () => {
      writeFileSync(output, '');
      throw new Error('it fails');
    }),
  );
  await unlessUnchanged(work, step);
  await unlessUnchanged(work, step);
  assert.equal(runs, 1);
  rmSync(output);
  await unlessUnchanged(work, step);
  assert.equal(runs, 2);
});
