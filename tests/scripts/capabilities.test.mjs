// The table of the paper's capabilities refers to existing files, tests and examples, and the page
// "What is checked" to existing files.

import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { at } from '../../.scripts/project.mjs';
import { filesUnder } from '../../.scripts/stamp.mjs';

const read = (path) => readFileSync(path, 'utf8');

/** The cells of each row. */
const rows = read(at('src', 'capabilities.md'))
  .split('\n')
  .filter((line) => line.startsWith('| '))
  .slice(1)
  .map((line) =>
    line
      .replace(/^\||\|$/g, '')
      .split('|')
      .map((cell) => cell.trim()),
  );

/** Quoted text in backticks, with the word before it. */
const quoted = (cell) =>
  [...cell.matchAll(/([^`,]*)`([^`]+)`/g)].map(([, what, name]) => [what.trim(), name]);

test('it has the 46 rows, each with a place, a check and a bound', () => {
  assert.deepEqual(
    rows.map(([number]) => Number(number)),
    Array.from({ length: 46 }, (_, k) => k + 1),
  );
  for (const row of rows) {
    assert.equal(row.length, 5, row[0]);
    assert.ok(row.every(Boolean), row[0]);
    assert.ok(quoted(row[2]).length > 0 && quoted(row[3]).length > 0, row[0]);
  }
});

test('every file, test and example that it names is there', () => {
  const declarations = filesUnder(at('src', 'generate', 'example'))
    .map(read)
    .join('\n');
  for (const [number, , code, checks] of rows) {
    for (const [, file] of quoted(code)) assert.ok(existsSync(at(file)), `${number}: ${file}`);
    for (const [what, name] of quoted(checks)) {
      if (what === 'example') {
        assert.ok(declarations.includes(`id: "${name}"`), `${number}: ${name}`);
        continue;
      }
      const [file, title] = name.split('::');
      const wanted = file.endsWith('.rs') ? `fn ${title}(` : `test('${title}'`;
      assert.ok(read(at(file)).includes(wanted), `${number}: ${file} has no ${title}`);
    }
  }
});

test('every path on the page about what is checked is there', () => {
  const page = read(at('www', 'checked.html'));
  const paths = [...page.matchAll(/<code>([\w./-]+\/[\w./-]*)<\/code>/g)].map(([, path]) => path);
  assert.ok(paths.length > 20, `${paths.length} paths`);
  for (const path of paths) assert.ok(existsSync(at(path)), path);
});
