// Compressed sizes of what the site loads. One bound: a visit from nothing that uses everything but
// Rhino's files.

import { readFileSync } from 'node:fs';
import { relative } from 'node:path';
import { gzipSync } from 'node:zlib';
import { at } from './project.mjs';
import { main, Problem } from './run.mjs';
import { filesUnder } from './stamp.mjs';

/** The bound in bytes. */
const MOST = 3e6;

/** Groups of files: the first pattern that a path in dist/ matches. Those without a name are not loaded by a visit. */
const GROUPS = [
  ['', /^sources\/|^licences|\.map$/],
  ['Rhino', /^assets\/(rhino|__vite)/],
  ['engine', /^assets\/engine-.*\.wasm$/],
  ['view, WebGPU', /^assets\/view-webgpu-/],
  ['view, WebGL2', /^assets\/view-webgl2-/],
  ['pages, scripts and styles', /\.(html|js|css)$/],
  ['examples and pictures', /^(examples|pictures)\//],
  ['other files', /./],
];

await main(() => {
  const sums = new Map();
  for (const path of filesUnder(at('dist'))) {
    const name = relative(at('dist'), path).replaceAll('\\', '/');
    const [group] = GROUPS.find(([, pattern]) => pattern.test(name));
    const bytes = readFileSync(path);
    const { raw, gzip } = sums.get(group) ?? { raw: 0, gzip: 0 };
    const small = gzipSync(bytes, { level: 9 }).length;
    sums.set(group, { raw: raw + bytes.length, gzip: gzip + small });
  }
  const line = (name, ...numbers) =>
    console.log(name.padEnd(28) + numbers.map((number) => String(number).padStart(11)).join(''));
  line('bytes', 'raw', 'gzip -9');
  for (const [name] of GROUPS.filter(([name]) => name && sums.has(name)))
    line(name, sums.get(name).raw, sums.get(name).gzip);
  // A visit loads one of the two views.
  const without = ['', 'Rhino', 'view, WebGPU'];
  const visit = [...sums].filter(([name]) => !without.includes(name));
  const total = visit.reduce((sum, [, { gzip }]) => sum + gzip, 0);
  line('a visit with WebGL2', '', total);
  if (total > MOST) throw new Problem(`A visit loads more than ${MOST} bytes.`);
});
