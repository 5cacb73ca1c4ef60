// Compressed sizes of what the site loads. There is one bound: what a visit from nothing loads, with
// what is kept for use without a network, and without Rhino's files.

import { readFileSync, readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { at } from './project.mjs';
import { main, Problem } from './run.mjs';

/** The bound in bytes. */
const MOST = 3e6;

/** Groups of files: a name, and a pattern of their names. */
const GROUPS = [
  ['engine and words', /(engine|words)-.*\.wasm$/],
  ['view', /view-web.*\.wasm$/],
  ['scripts', /\.js$/],
  ['pages and styles', /(\.html|\.css|\/)$/],
  ['examples', /^\.\/examples\//],
  ['other files', /./],
];

/** The lists of files that the build puts at the head of the service worker. */
function listedFiles() {
  const [, lists] = readFileSync(at('dist', 'service-worker.js'), 'utf8').match(
    /^const SITE = (.*);$/m,
  );
  return JSON.parse(lists);
}

const compressed = (name) => {
  const file = join(at('dist'), name.endsWith('/') ? `${name}index.html` : name);
  return gzipSync(readFileSync(file), { level: 9 }).length;
};

await main(() => {
  const { files, views } = listedFiles();
  const line = (name, bytes) => console.log(name.padEnd(24) + String(bytes).padStart(10));
  let total = 0;
  line('kept by a visit', 'gzip -9');
  // A browser loads one of the views, and one of the pictures of the first screen: the larger one
  // counts.
  const firsts = readdirSync(at('dist', 'assets')).filter((name) => /^first-.*webp$/.test(name));
  const bytes = (name) => statSync(at('dist', 'assets', name)).size;
  const [first] = firsts.sort((a, b) => bytes(b) - bytes(a));
  const rest = new Set([
    ...[...files, ...views.webgl2, './service-worker.js'],
    ...(first ? [`./assets/${first}`] : []),
  ]);
  for (const [group, pattern] of GROUPS) {
    const own = [...rest].filter((name) => pattern.test(name));
    for (const name of own) rest.delete(name);
    const bytes = own.reduce((sum, name) => sum + compressed(name), 0);
    line(group, bytes);
    total += bytes;
  }
  line('a visit from nothing', total);
  if (total > MOST) throw new Problem(`A visit from nothing loads more than ${MOST} bytes.`);
});
