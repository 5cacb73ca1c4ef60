// The documentation names files, functions and modules that exist, in the crate and in the page.

import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { at } from '../../.scripts/project.mjs';
import { filesUnder } from '../../.scripts/stamp.mjs';

const read = (path) => readFileSync(path, 'utf8');

test('what the documentation of the crate names is there', () => {
  const code = filesUnder(at('src'))
    .filter((path) => path.endsWith('.rs'))
    .map(read)
    .join('\n');
  const isFile = (path) =>
    ['', 'src'].some((folder) =>
      ['', '.rs'].some((ending) => existsSync(at(folder, path + ending))),
    );
  // A function by its type and name, or a module by its path.
  const isItem = (path) =>
    code.includes(`fn ${path.split('::').at(-1)}(`) || isFile(path.replaceAll('::', '/'));
  const lines = read(at('src', 'lib.rs')).split('\n');
  // Names stand in backquotes. Rustdoc checks those in brackets. Blocks of code are no names.
  const parts = lines
    .filter((line) => line.startsWith('//!'))
    .join('\n')
    .replaceAll('```', '')
    .split('`');
  const names = parts.filter(
    (name, i) => i % 2 === 1 && !parts[i - 1].endsWith('[') && /^[\w:/.]*[:/][\w:/.]*$/.test(name),
  );
  assert.ok(names.length > 50, `${names.length} names`);
  const missing = names.filter((name) => !(name.includes('/') ? isFile(name) : isItem(name)));
  assert.deepEqual(missing, []);
});

test('what the README links to is there', () => {
  const links = [...read(at('README.md')).matchAll(/\]\(([^)]*)\)/g)].map(([, link]) => link);
  const files = links.filter((link) => !link.startsWith('http'));
  assert.ok(files.length > 3, files.join());
  assert.deepEqual(
    files.filter((file) => !existsSync(at(file))),
    [],
  );
});
