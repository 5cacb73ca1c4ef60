// How much of the site a visitor loads, compressed as static hosts do, against its budgets.

import { basename, extname, relative } from 'node:path';
import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { at } from './project.mjs';
import { main, Problem } from './run.mjs';
import { filesUnder } from './stamp.mjs';

const kB = 1000;
const gzipped = (path) => gzipSync(readFileSync(path), { level: 9 }).length;
const sum = (paths) => paths.reduce((bytes, path) => bytes + gzipped(path), 0);

await main(() => {
  const dist = filesUnder(at('dist')).filter(
    (path) => !relative(at('dist'), path).startsWith('examples'),
  );
  // The plots load when they are first shown.
  const later = (path) => basename(path).toLowerCase().includes('uplot');
  const code = dist.filter((path) => ['.html', '.js', '.css'].includes(extname(path)));
  const rows = [
    ['solver module', sum([at('www', 'pkg', 'solver', 'shape_up_bg.wasm')]), 150 * kB],
    ['view module', sum([at('www', 'pkg', 'view', 'shape_up_bg.wasm')]), 900 * kB],
    ['page: HTML, CSS, JavaScript', sum(code.filter((path) => !later(path))), 60 * kB],
    ['plots', sum(code.filter(later)), 30 * kB],
  ];
  console.log('gzip                          bytes    budget');
  for (const [name, bytes, budget] of rows) {
    console.log(`${name.padEnd(28)}${String(bytes).padStart(7)}${String(budget).padStart(10)}`);
  }
  const over = rows.filter(([, bytes, budget]) => bytes > budget).map(([name]) => name);
  if (over.length) throw new Problem(`Over the budget: ${over.join(', ')}`);
});
