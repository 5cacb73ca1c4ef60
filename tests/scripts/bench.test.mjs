// The evaluation of the benchmark's measurements.

import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { marks, optionsOf, page, writeTables } from '../../.scripts/bench/bench.mjs';
import { casesOf, parts, tablesOf } from '../../.scripts/bench/parts.mjs';
import { peers } from '../../.scripts/bench/peers.mjs';
import { problemOf, problems } from '../../.scripts/bench/problems.mjs';
import { isQuiet, otherLoadText } from '../../.scripts/bench/quiet.mjs';
import { median, repeated, spread, spreads } from '../../.scripts/bench/statistics.mjs';
import { writeNumbers } from '../../.scripts/bench/readme.mjs';
import { number, table } from '../../.scripts/bench/tables.mjs';
import { formulas, kernels, reasons, sizesOf, workOf } from '../../.scripts/bench/work.mjs';
import { at } from '../../.scripts/project.mjs';

const quiet = { busy: 0.1, stalled: 0.001 };
const busy = { ...quiet, busy: 1.04 };

test('medians are those of the sorted values, of each property', () => {
  assert.equal(median([10, 9, 1, 2, 3]), 3);
  assert.equal(median([]), null);
  const all = [
    { a: 1, b: 9 },
    { a: 3, b: 7 },
    { a: 2, b: 8 },
  ];
  const { a, b } = spreads(all);
  assert.deepEqual([a.median, b.median, b.low, b.high, b.runs], [2, 8, 7, 9, 3]);
  // The middle half of eleven.
  const eleven = spread([11, 1, 10, 2, 9, 3, 8, 4, 7, 5, 6]);
  assert.deepEqual(eleven, { median: 6, low: 3, high: 9, runs: 11 });
});

test('what is quick is measured several times, and only its time is spread', async () => {
  let k = 0;
  const found = await repeated('seconds', () => ({ seconds: ++k, distance: 7 }));
  assert.deepEqual(found, { seconds: { median: 3, low: 2, high: 4, runs: 5 }, distance: 7 });
});

test('numbers keep three significant digits, tiny ones their power of ten', () => {
  const values = [0.01234, 0.43, 1.234, 12.34, 1431.4, 12345, 2e-14, null, undefined];
  const texts = ['0.012', '0.430', '1.23', '12.3', '1,430', '12,345', '2e-14', '–', '–'];
  assert.deepEqual(values.map(number), texts);
});

test('a table has the rows with a measurement, and the columns with a value', () => {
  const columns = 'name | time = a.ms | to the goal = a.goal | nothing';
  const seconds = spread([0.4, 0.5, 0.6]);
  const rows = [
    { name: 'one', a: { ms: spread([1.25]), goal: { seconds, iterations: 12 } } },
    { name: 'two', a: { goal: { seconds: spread([3.01]), iterations: null } } },
    { name: 'three', a: { ms: spread([2, 2, 2]) } },
    { name: 'failed' },
  ];
  assert.equal(
    table(columns, rows),
    [
      '| name | time | to the goal |',
      '|---|---|---|',
      '| one | 1.25 (once) | 0.500 (0.400–0.600; 12 iterations) |',
      '| two | – | > 3.01 |',
      '| three | 2 | – |',
    ].join('\n'),
  );
  assert.equal(table('name | other = b.ms', rows), null);
});

test('command line options are checked', () => {
  assert.throws(() => optionsOf(['--sizes', 'many']), /--sizes many/);
  assert.throws(() => optionsOf(['--problems', 'A,Q']), /--problems Q.* of A,B,C,D,E/s);
  assert.throws(() => optionsOf(['--fast']), /--fast/);
  assert.throws(() => optionsOf(['--write']), /--write/);
  for (const words of [['--trial'], ['--sizes', '900'], ['--where', 'native']])
    assert.throws(() => optionsOf(['--full', '--write', ...words]), /--write/);
  const { parts: named } = optionsOf([]);
  assert.ok(named.includes('start') && !named.includes('peers'));
  assert.ok(optionsOf(['--full', '--write']).parts.includes('peers'));
});

test('a part measures its problems in the sizes asked for', () => {
  const casesFor = (...words) => casesOf('iterations', optionsOf(words));
  const problems = (cases) => cases.map(({ problem }) => problem).join('');
  assert.equal(problems(casesFor('--sizes', '900')), 'ABC');
  assert.deepEqual(casesFor('--sizes', '900', '--problems', 'D,E'), [{ problem: 'E', size: 900 }]);
  assert.equal(problems(casesFor()), 'ABCABC');
  const sizes = casesFor('--full').map(({ size }) => size);
  assert.deepEqual([...new Set(sizes)], [500, 1000, 2500, 10_000, 30_000, 100_000]);
});

test('peers get problems that exist', () => {
  for (const name of peers.flatMap((peer) => peer.problems)) assert.ok(problems[name], name);
});

test('the work of an iteration is counted from sizes', () => {
  // 36 vertices in 25 quads with 60 edges, 85 if they are split.
  const [n, corners, z] = [36, 100, 7];
  const a = sizesOf(problemOf('A', 36), z);
  assert.deepEqual(a, {
    ...{ kind: 'circle', without: [] },
    sizes: { n, e: 120, m: 25, p: corners, z },
  });
  const { projections, smoothness, 'global step': step } = workOf(a);
  const [once, each] = kernels.circle.operations;
  assert.equal(projections.double, 25 * (once + 4) + corners * (each + 35));
  assert.equal(projections.bytes, 96 * n + 4 * corners);
  assert.deepEqual([smoothness.bytes, smoothness.double], [168 * n + 24 * 120, 12 * n + 18 * 120]);
  assert.deepEqual([step.bytes, step.single], [708 * n + 8 * z, 165 * n + 12 * z]);

  // A ring is a vertex with its neighbours.
  const c = sizesOf(problemOf('C', 36), z);
  assert.deepEqual(c.sizes, { n, e: 170, m: n, p: n + 170, z });
  assert.deepEqual(Object.keys(workOf(c)), ['projections', 'global step', 'the rest']);
  // The boundary curves of E, and maps, have no formula.
  for (const letter of ['D', 'E']) assert.equal(sizesOf(problemOf(letter, 36), z), null);
});

test('the documentation has the operations that are counted', () => {
  const text = readFileSync(at(page), 'utf8');
  for (const [kind, { operations, divisions }] of Object.entries(kernels)) {
    const form = ([once, each]) => (each ? `${once} + ${each} p` : `${once}`);
    assert.ok(text.includes(`\n| ${kind} | ${form(operations)} | ${form(divisions)} |\n`), kind);
    assert.ok(formulas().includes(`| projections, ${kind} |`));
  }
});

test('it is said where the time is that is above twice the limit', () => {
  const row = (problem, vertices, times, share) => ({
    ...{ problem, vertices },
    limit: {
      times,
      parts: {
        projections: { share, times: 2.5 },
        'global step': { share: 0.9 - share, times: 4 },
        'the rest': { share: 0.1, times: 9 },
      },
    },
  });
  const said = reasons([
    row('A', 500, 3, 0.3),
    row('A', 900, 2.5, 0.4),
    row('B', 500, 1.9, 0.3),
    { problem: 'E' },
  ]);
  assert.deepEqual(said, [
    'A with 500, 900 vertices takes 2.50 to 3 times its limit. Of its time: global step 50 to 60 % (4 times its own limit), projections 30 to 40 % (2.50 times its own limit).',
  ]);
});

test('the numbers of the README are those of the run', () => {
  const its = (...times) => spread(times);
  const quads = [0.1, 0.2, 0.3, 0.4].map((mean) => ({ surface: 'vault', quads: { mean } }));
  const plain = { none: { total: its(7) }, 'quasi-newton': { total: its(8) } };
  const rows = {
    iterations: [{ problem: 'A', vertices: 29_929, browser: plain }],
    quads: [...quads, { surface: 'hills', quads: { mean: 9 } }],
    start: [{ visit: 'first visit', seen: { drawn: its(3000) } }],
    peers: [
      {
        ...{ problem: 'rough circles', its: its(9), itsDistance: 0.004 },
        exact: { distance: 3e-13, seconds: its(0.5) },
      },
      { problem: 'circles', its: its(14), ours: { native: its(1), browser: its(2) } },
    ],
  };
  const before = readFileSync(at('README.md'), 'utf8').split('\n');
  const path = join(mkdtempSync(join(tmpdir(), 'shape-up-bench-')), 'README.md');
  writeFileSync(path, before.join('\n'));
  writeNumbers(rows, path);
  const after = readFileSync(path, 'utf8').split('\n');
  const changed = after.filter((line, k) => line !== before[k]);
  assert.equal(after.length, before.length);
  assert.deepEqual(
    changed.map((line) => line.split(' | ')[1]),
    [
      '7 ms, accelerated 8',
      '3e-13 in 0.500 s; compas_shapeop 0.004 in 9 s',
      '0.100; quads of Instant Meshes 0.300, of QuadriFlow 0.400',
      '2 ms in the browser, 1 natively; compas_shapeop 14',
      '3,000 ms',
    ],
  );
  assert.match(changed[0], /^\| An iteration .* \| `npm run bench .*` \|$/);
  assert.throws(() => writeNumbers({ ...rows, start: [] }, path), /no measurement of first visit/);
});

test('a machine is not quiet if others compute, or take our core', () => {
  assert.ok(isQuiet(quiet));
  assert.ok(!isQuiet(busy) && !isQuiet({ ...quiet, stalled: 0.1 }));
  assert.match(otherLoadText(quiet, busy), /not quiet.* 0\.1 and 1\.0 cores/);
});

/** Writes results of a machine with some other load into an empty page; returns what it is then. */
function written(...moments) {
  const folder = mkdtempSync(join(tmpdir(), 'shape-up-bench-'));
  const path = join(folder, 'page.md');
  const iterations = [
    {
      ...{ problem: 'A', vertices: 2500 },
      browser: { 'quasi-newton': { total: 1.25 } },
      native: { none: { total: 77 } },
    },
  ];
  writeFileSync(path, `# Title\n${marks.join('')}The end.\n`);
  try {
    writeTables({ machine: 'Here.', moments, rows: { iterations } }, path);
    return readFileSync(path, 'utf8');
  } catch ({ message }) {
    return { message, text: readFileSync(path, 'utf8') };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('the tables are written between the marks', () => {
  const text = written(quiet, quiet);
  assert.match(
    text,
    /^# Title\n<!-- speed.*Here\..*\| A \| 2,500 \| 1\.25 \|.*end of.*The end\.\n$/s,
  );
  assert.match(text, /\| A \| 2,500 \| 77 \|/);
});

test('nothing is written if the machine was not quiet, before or after', () => {
  for (const moments of [
    [quiet, busy],
    [busy, quiet],
  ]) {
    const { message, text } = written(...moments);
    assert.match(message, /not quiet.*tables are not written/);
    assert.equal(text, `# Title\n${marks.join('')}The end.\n`);
  }
});

test('the documentation has tables that the benchmark writes, and no others', () => {
  const text = readFileSync(at(page), 'utf8');
  for (const mark of marks) assert.equal(text.split(mark).length, 2, mark);
  const section = text.split(marks[0])[1].split(marks[1])[0];
  const titles = Object.keys(parts).flatMap((name) => tablesOf(name).map(([title]) => title));
  const written = section.match(/^.*:$/gm);
  assert.ok(written.length >= 9);
  for (const title of written) assert.ok(titles.includes(title), title);
});
