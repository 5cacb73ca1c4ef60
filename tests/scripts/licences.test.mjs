// Everything shipped has an allowed licence and its text; anything else is refused.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  alternatives,
  assertLicensed,
  licencesOf,
  shipped,
  textsOf,
} from '../../.scripts/licences.mjs';
import { at } from '../../.scripts/project.mjs';

const component = (expression, name = 'newcomer') => ({
  ...{ name, version: '1.0.0', expression, authors: 'somebody', folder: null, address: '' },
});

test('shipped components have allowed licences and bring their texts', () => {
  const all = shipped();
  const names = all.map(({ name }) => name);
  // From the solver, the view, the page, and the code added by the bundler.
  for (const name of [
    'sprs-ldl',
    'amd',
    'wgpu',
    'uplot',
    'rhino3dm',
    'vite',
    'Rust standard library',
  ])
    assert.ok(names.includes(name), name);
  // Build-time code generators and test dependencies are not shipped.
  for (const name of ['serde_derive', 'proptest', 'wasm-bindgen-test', 'eslint'])
    assert.ok(!names.includes(name), name);
  for (const one of all) for (const text of textsOf(one)) assert.ok(text.length > 200, one.name);
  const [lgpl] = textsOf(all.find(({ name }) => name === 'sprs-ldl'));
  assert.match(lgpl, /GNU LESSER GENERAL PUBLIC LICENSE\s+Version 2\.1/);
});

test('a new component under another licence, or under none, is refused', () => {
  for (const expression of ['GPL-3.0-only', 'LGPL-2.1', 'MIT AND GPL-2.0', '', 'SEE LICENSE'])
    assert.throws(() => licencesOf(component(expression)), /newcomer 1\.0\.0 is under/, expression);
  assert.throws(() => licencesOf(component('GPL-3.0', 'sprs-ldl')), /sprs-ldl/);
  assert.throws(
    () => textsOf(component('Apache-2.0')),
    /does not contain the text of that licence/,
  );
  assert.throws(
    () => assertLicensed(at('node_modules', 'axe-core', 'axe.js')),
    /axe-core is bundled/,
  );
  assertLicensed(at('node_modules', 'uplot', 'dist', 'uPlot.esm.js'));
  assertLicensed(at('www', 'app', 'main.ts'));
});

test('of several licences the first allowed one is taken', () => {
  assert.deepEqual(alternatives('(MIT OR Apache-2.0) AND Unicode-3.0'), [
    ['MIT', 'Unicode-3.0'],
    ['Apache-2.0', 'Unicode-3.0'],
  ]);
  assert.deepEqual(licencesOf(component('GPL-2.0 OR Apache-2.0 OR MIT')), ['MIT']);
  assert.deepEqual(licencesOf(component('MIT/Apache-2.0')), ['MIT']);
});
