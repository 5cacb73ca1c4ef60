// What a step looks at is among what decides whether it runs again.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { test } from 'node:test';
import { site, stages } from '../../.scripts/checks.mjs';
import { at, program } from '../../.scripts/project.mjs';
import { inputs } from '../../.scripts/site.mjs';

test('the page is tested again after a change of the program with which it is compared', () => {
  const files = ['index.html', 'npm/index.js', 'sources/shape-up.tar.gz'];
  const found = site(files.map((name) => at('dist', ...name.split('/'))));
  assert.ok(found.includes(program));
  assert.deepEqual(
    found.filter((path) => path.startsWith(at('dist'))),
    [at('dist', 'index.html')],
  );
});

test('the native tests run again after a change of the results with which they are compared', () => {
  const native = stages.test.flat(2).filter(({ title }) => title.startsWith('native tests'));
  assert.equal(native.length, 2);
  for (const { inputs: of } of native) {
    assert.ok(of().includes(at('.clippy.toml')));
    assert.equal(of().includes(at('..', 'shared')), existsSync(at('..', 'shared')));
  }
});

test('the site is bundled again after a change of what its page of licences shows', () => {
  assert.ok(inputs().includes(at('LICENSE')) && inputs().includes(at('.scripts')));
});
