// The page about speed: what is plotted is what the text has.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { exponent, speedTexts, timesIn } from '../../.scripts/speed-page.mjs';
import { at } from '../../.scripts/project.mjs';

test('the exponent of a power is that of the power', () => {
  const points = [10, 100, 5000].map((n) => [n, 3 * n ** 1.5]);
  assert.ok(Math.abs(exponent(points) - 1.5) < 1e-12);
});

test('a time is the median before its spread', () => {
  const text =
    'In the browser, milliseconds, medians:\n\n| problem | vertices | iteration |\n|---|---|---|\n| A | 2,500 | 0.590 (0.570–0.640) |\n\n';
  assert.deepEqual(timesIn(text).get('A'), [[2500, 0.59]]);
});

test('each time of the published table is plotted, and the page has its table', () => {
  const text = readFileSync(at('src', 'solve', 'performance.md'), 'utf8');
  const times = timesIn(text);
  assert.deepEqual([...times.keys()], ['A', 'B', 'C']);
  for (const points of times.values()) {
    assert.ok(points.length >= 4);
    assert.ok(points.flat().every((value) => value > 0));
    // The larger the slower.
    assert.deepEqual(
      points.toSorted((one, other) => one[1] - other[1]),
      points,
    );
  }
  const html = speedTexts(readFileSync(at('www', 'speed.html'), 'utf8'));
  const lines = html.match(/<path class="[ABC]" d="M[\d.]+ [\d.]+(L[\d.]+ [\d.]+)+"/g);
  const plotted = lines.map((line) => line.split('L').length);
  assert.deepEqual(
    plotted,
    [...times.values()].map(({ length }) => length),
  );
  const [, time] = /^\| A \| 10,000 \| ([^|]*) \|/m.exec(text);
  assert.ok(html.includes(`<td>${time}</td>`));
  assert.doesNotMatch(html, /<!-- (plot|text)/);
});

test('the numbers of the README are in the tables of the speed page', () => {
  const section = readFileSync(at('README.md'), 'utf8')
    .split('## Five numbers')[1]
    .split('\n\n')[1];
  const tables = readFileSync(at('src', 'solve', 'performance.md'), 'utf8').split('## Tables')[1];
  const measured = new Set(tables.match(/\d[\d,.e-]*/g).map((number) => number.replace(/,/g, '')));
  const rows = section.split('\n').slice(2);
  assert.equal(rows.length, 5);
  for (const row of rows) {
    const claimed = row.split('|')[2].match(/\d[\d,.e-]*/g);
    for (const number of claimed) assert.ok(measured.has(number.replace(/,/g, '')), row);
  }
});

test('a visit is as large as the README says', () => {
  const most = (path, pattern) => Number(pattern.exec(readFileSync(at(path), 'utf8'))[1]);
  const claimed = most('README.md', /A first visit, of at most (\d+) MB/);
  // `npm run check` fails beyond it.
  assert.equal(most('.scripts/sizes.mjs', /^const MOST = (.*);$/m), claimed * 1e6);
});
