// Each test that is left to the night is there under its name.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';
import { NIGHTLY, patternOf } from './nightly.ts';

test('what only the night runs is among the tests', () => {
  const args = ['test', '--config', 'tests/page/playwright.config.ts', '--list'];
  const env = { ...process.env, LONG: '1' };
  const listed = execFileSync('node_modules/.bin/playwright', args, { env, encoding: 'utf8' });
  const names = [...listed.matchAll(/^ *\[(\w+)\] › (\S+?):\d+:\d+ › (.*)$/gm)].map(
    ([, project, file, title]) => `${project} ${file} ${title}`,
  );
  for (const group of NIGHTLY) {
    const found = names.filter((name) => patternOf(group).test(name));
    assert.equal(found.length, group.titles.length, `${group.spec}: ${found.join('; ')}`);
  }
});
