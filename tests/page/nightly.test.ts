// The tests that are left to the night, and no others, are left out of the day.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';
import { NIGHTLY } from './nightly.ts';

/** The tests that Playwright would run, each as its project, its file and its title. */
function listed(long: string) {
  const args = ['test', '--config', 'tests/page/playwright.config.ts', '--no-deps', '--list'];
  const env = { ...process.env, LONG: long };
  const text = execFileSync('node_modules/.bin/playwright', args, { env, encoding: 'utf8' });
  return [...text.matchAll(/^ *\[(\w+)\] › (\S+?):\d+:\d+ › (.*)$/gm)].map(
    ([, project, file, title]) => ({ project, file, title }),
  );
}

test('what only the night runs is what the list names', () => {
  const day = new Set(listed('').map((one) => Object.values(one).join(' ')));
  const left = listed('1').filter((one) => !day.has(Object.values(one).join(' ')));
  const wanted = NIGHTLY.flatMap((group) => group.titles.map((title) => ({ ...group, title })));
  for (const { spec, title, project } of wanted) {
    const found = left.filter(
      (one) =>
        one.file.endsWith(`${spec}.spec.ts`) &&
        one.title.startsWith(title) &&
        one.project === (project ?? one.project),
    );
    assert.equal(found.length, 1, `${spec}: ${title}`);
  }
  assert.equal(left.length, wanted.length, left.map(({ title }) => title).join('; '));
});
