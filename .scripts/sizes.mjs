// How much of the site a visitor loads, compressed as static hosts do, against its budgets.

import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { gzipSync } from 'node:zlib';
import { firstPicture } from './examples.mjs';
import { at } from './project.mjs';
import { main, Problem } from './run.mjs';
import { filesUnder } from './stamp.mjs';

const kB = 1000;
const compressed = (bytes) => gzipSync(bytes, { level: 9 }).length;

/** A file without the first picture, which has a line of its own. */
function contents(path) {
  if (!path.endsWith('.html') || path === firstPicture) return readFileSync(path);
  return Buffer.from(readFileSync(path, 'utf8').replace(readFileSync(firstPicture, 'utf8'), ''));
}

/** A line of the table: the sizes of some files together, and what they may be. */
function row(name, paths, budget) {
  const files = paths.map(contents);
  const sum = (size) => files.reduce((total, bytes) => total + size(bytes), 0);
  return { name, raw: sum((bytes) => bytes.length), gzip: sum(compressed), budget };
}

await main(() => {
  const code = filesUnder(at('dist')).filter((path) => /\.(html|css|js)$/.test(path));
  // The plots, and uPlot with them, load when they are first shown; what Share and Export need, and
  // what reads and writes files of Rhino, when it is first used.
  const isPlot = (path) => basename(path).toLowerCase().includes('plot');
  // Pages of their own.
  const isBeside = (path) => /^(gallery|projections|reading)\b/.test(basename(path));
  const isRhino = (path) => /^(rhino|__vite)/.test(basename(path));
  const isSeldom = (path) => /^(dialog-(share|export)|share-link|keeping)/.test(basename(path));
  const isLater = (path) => isPlot(path) || isRhino(path) || isSeldom(path);
  const rows = [
    row('solver module', [at('www', 'pkg', 'solver', 'shape_up_bg.wasm')], 540 * kB),
    row('view module', [at('www', 'pkg', 'view', 'shape_up_bg.wasm')], 900 * kB),
    row(
      'HTML, CSS, JavaScript',
      code.filter((path) => !isLater(path) && !isBeside(path)),
      60 * kB,
    ),
    row('gallery, projections', code.filter(isBeside), 16 * kB),
    row('first picture', [firstPicture], 14 * kB),
    row('plots', code.filter(isPlot), 30 * kB),
    row('Share and Export', code.filter(isSeldom), 8 * kB),
    row('files of Rhino', filesUnder(at('dist')).filter(isRhino), 1100 * kB),
  ];
  const line = (name, ...numbers) =>
    console.log(name.padEnd(22) + numbers.map((number) => String(number).padStart(11)).join(''));
  line('bytes', 'raw', 'gzip -9', 'budget');
  for (const { name, raw, gzip, budget } of rows) line(name, raw, gzip, budget);

  const over = rows.filter(({ gzip, budget }) => gzip > budget).map(({ name }) => name);
  if (over.length) throw new Problem(`Over the budget: ${over.join(', ')}`);
});
