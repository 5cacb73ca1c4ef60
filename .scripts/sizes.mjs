// Compressed sizes of the site's downloads, against their budgets.

import { existsSync, readFileSync, statSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { at } from './project.mjs';
import { main, Problem } from './run.mjs';
import { filesUnder } from './stamp.mjs';

const kB = 1000;
const compressed = (bytes) => gzipSync(bytes, { level: 9 }).length;

/** Returns a row of the table: the total size of some files, and their budget. */
function row(name, paths, budget) {
  const files = paths.map((path) => readFileSync(path));
  const sum = (size) => files.reduce((total, bytes) => total + size(bytes), 0);
  return { name, raw: sum((bytes) => bytes.length), gzip: sum(compressed), budget };
}

/** Returns the files of dist/ that a page needs before it works, directly or indirectly. */
function firstNeeded(page) {
  const found = new Set([page]);
  for (const path of found) {
    const text = readFileSync(path, 'utf8');
    // Stylesheets, modules and preloads; imports; workers. An import() is loaded later.
    const names = path.endsWith('.html')
      ? text.matchAll(/(?:src|href)="\.\/([^"]+\.(?:js|css))"/g)
      : text.matchAll(/(?:\bfrom|\bimport|new URL\()\s*["'`](?:\.\/)?([\w./-]+\.js)["'`]/g);
    for (const [, name] of names) {
      const file = [dirname(path), at('dist')].map((folder) => join(folder, name)).find(existsSync);
      if (file) found.add(file);
    }
  }
  return [...found];
}

/** Files loaded on first use: a name, a pattern of their names, and a budget in kB. */
const LATER = [
  ['plots', /plot/i, 30],
  ['parts and sheets', /^(build-worker|build-panel|build-goals|live-build)/, 19.5],
  ['variations', /^(variation|docked|thumbnail)/, 9],
  ['new mesh', /^dialog-new-mesh/, 13],
  ['curvature', /^curvature/, 9],
  ['refining', /^refine/, 4],
  ['presentations', /^(present|stage|steps-dialog)/, 6],
  ['links', /^packed-scene/, 8],
  ['sharing, embedded', /^(embedded-view|dialog-share|share)/, 12],
  ['licences', /^licences/, 24],
];

const OTHER_PAGES = ['gallery.html', 'projections.html', 'embed.html', 'embedding.html'];

await main(() => {
  const site = filesUnder(at('dist'));
  const code = site.filter((path) => /\.(html|css|js)$/.test(path));
  // The first visit also loads the JavaScript of one view module: the larger one counts.
  const glue = code.filter((path) => /^view-web/.test(basename(path)));
  const [largest] = glue.sort((a, b) => statSync(b).size - statSync(a).size);
  // The service worker is loaded too, after the first picture.
  const worker = at('dist', 'service-worker.js');
  const first = new Set([...firstNeeded(at('dist', 'index.html')), largest, worker]);
  const ofPages = new Set(OTHER_PAGES.flatMap((name) => firstNeeded(at('dist', name))));
  const isRhino = (path) => /^(rhino|__vite)/.test(basename(path));

  const pages = [];
  const others = [];
  const later = new Map(LATER.map(([name]) => [name, []]));
  for (const path of code) {
    if (first.has(path) || glue.includes(path) || isRhino(path)) continue;
    const found = LATER.find(([, pattern]) => pattern.test(basename(path)));
    if (ofPages.has(path)) pages.push(path);
    else (found ? later.get(found[0]) : others).push(path);
  }
  const module = (name, folder, budget) =>
    row(name, [at('www', 'pkg', folder, 'shape_up_bg.wasm')], budget * kB);
  const rows = [
    module('solver module', 'solver', 713),
    module('parts module', 'build', 311),
    module('view, WebGPU', 'view-webgpu', 189),
    module('view, WebGL2', 'view-webgl2', 900),
    row('first visit', [...first], 78 * kB),
    ...LATER.map(([name, , budget]) => row(name, later.get(name), budget * kB)),
    row('other dialogs', others, 85.5 * kB),
    row('other pages', pages, 20 * kB),
    row('files of Rhino', site.filter(isRhino), 1100 * kB),
  ];
  const line = (name, ...numbers) =>
    console.log(name.padEnd(22) + numbers.map((number) => String(number).padStart(11)).join(''));
  line('bytes', 'raw', 'gzip -9', 'budget');
  for (const { name, raw, gzip, budget } of rows) line(name, raw, gzip, budget);

  const over = rows.filter(({ gzip, budget }) => gzip > budget).map(({ name }) => name);
  if (over.length) throw new Problem(`Over the budget: ${over.join(', ')}`);
});
