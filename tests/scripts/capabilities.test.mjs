// The tables of the paper's capabilities refer to existing files, tests and examples, and the page
// "What is checked" to existing files.

import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { at } from '../../.scripts/project.mjs';
import { filesUnder } from '../../.scripts/stamp.mjs';

const read = (path) => readFileSync(path, 'utf8');

/** The texts of the pages. */
const pages = filesUnder(at('src', 'capabilities'))
  .filter((path) => path.endsWith('.md'))
  .map(read);

/** The cells of each row, by their numbers. */
const rows = pages
  .flatMap((page) => page.split('\n'))
  .filter((line) => /^\| \d/.test(line))
  .sort((one, other) => parseInt(one.slice(2)) - parseInt(other.slice(2)))
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

test('each page shows pictures, of examples that its table names', () => {
  const declared = read(at('src', 'lib.rs'));
  const modules = declared.matchAll(
    /include_str!\("capabilities\/(\w+\.md)"\)\]\n((?: *#\[doc = picture.*\n)+) *pub mod/g,
  );
  const shown = [...modules].map(([, file, pictures]) => [file, pictures.match(/[\w-]+(?="\))/g)]);
  assert.equal(shown.length, pages.length - 1, 'all but the overview');
  for (const [file, examples] of shown)
    for (const id of examples) {
      assert.ok(
        read(at('src', 'capabilities', file)).includes(`example \`${id}\``),
        `${file}: ${id}`,
      );
      assert.ok(existsSync(at('www', 'pictures', `${id}-end.webp`)), id);
    }
});

test('every path on the page about what is checked is there', () => {
  const page = read(at('www', 'checked.html'));
  const paths = [...page.matchAll(/<code>([\w./-]+\/[\w./-]*)<\/code>/g)].map(([, path]) => path);
  assert.ok(paths.length > 20, `${paths.length} paths`);
  for (const path of paths) assert.ok(existsSync(at(path)), path);
});
