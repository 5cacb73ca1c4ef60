// How much of the site a visitor loads, compressed as static hosts do, against its budgets.

import { existsSync, readFileSync, statSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
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

/** The files of dist/ that a page needs before it works: those that it and they name as such. */
function firstNeeded(page) {
  const found = new Set([page]);
  for (const path of found) {
    const text = readFileSync(path, 'utf8');
    // Styles, modules and what is loaded ahead; imports; workers. An import() is for later.
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

await main(() => {
  const code = filesUnder(at('dist')).filter((path) => /\.(html|css|js)$/.test(path));
  // The view's side in JavaScript is loaded with its module, at the first visit too, for WebGPU or for
  // WebGL2: the larger one counts.
  const glue = code.filter((path) => /^view-web/.test(basename(path)));
  const [largest, ...others] = glue.sort((a, b) => statSync(b).size - statSync(a).size);
  // So is the service worker, after the first picture.
  const worker = at('dist', 'service-worker.js');
  const first = new Set([...firstNeeded(at('dist', 'index.html')), largest, worker]);
  const beside = ['gallery.html', 'projections.html', 'embed.html', 'embedding.html'].flatMap(
    (name) => firstNeeded(at('dist', name)),
  );
  const isBeside = (path) => beside.includes(path) && !first.has(path);
  // The plots, and uPlot with them, load when they are first shown.
  const isPlot = (path) => basename(path).toLowerCase().includes('plot');
  // Parts and sheets, and meshes to begin with, come with their own module: the check in the view and the thickness took 3 kB and 5 kB.
  const isOfParts = (path) =>
    /^(build-worker|build-panel|build-goals|live-build)/.test(basename(path));
  // Variations come when they are first looked at; 26 kB of the solver module are theirs.
  // The dialog of refining comes when it is asked for; 15 kB of the solver module are subdivision and what goes along.
  // Improving what is exact is about 4 kB of it, the sixteen operations on the mesh 32 kB.
  const isOfRefining = (path) => /^refine/.test(basename(path));
  // The dialog of New mesh comes when it is asked for, too.
  const isOfBegin = (path) => /^dialog-new-mesh/.test(basename(path));
  // So does the card about curvature, with its worker.
  const isOfCurvature = (path) => /^curvature/.test(basename(path));
  const isOfVariations = (path) => /^(variation|docked)/.test(basename(path));
  // An embedded view, once it is started, and the dialog of Share with its code to scan come for themselves.
  const isOfSharing = (path) => /^(embedded-view|dialog-share|share)/.test(basename(path));
  // Presentations, and what codes the mesh of a link, come when they are asked for.
  const isOfPresenting = (path) => /^(present|stage|steps-dialog)/.test(basename(path));
  const isOfLinks = (path) => /^packed-scene/.test(basename(path));
  const isRhino = (path) => /^(rhino|__vite)/.test(basename(path));
  const isOther = (path) => others.includes(path);
  const isLicences = (path) => /^licences/.test(basename(path));
  const isLater = (path) =>
    !isLicences(path) &&
    !isOther(path) &&
    !first.has(path) &&
    !isBeside(path) &&
    !isPlot(path) &&
    !isOfParts(path) &&
    !isOfVariations(path) &&
    !isOfRefining(path) &&
    !isOfBegin(path) &&
    !isOfCurvature(path) &&
    !isOfSharing(path) &&
    !isOfPresenting(path) &&
    !isOfLinks(path) &&
    !isRhino(path);
  const rows = [
    // The forecast of how far a mesh will move is 5 kB of it, the steps of a presentation 7 kB.
    row('solver module', [at('www', 'pkg', 'solver', 'shape_up_bg.wasm')], 696 * kB),
    // Meshes to begin with are 32 kB of it: a plan, which is divided and raised, took 24 kB.
    // Parts that lie in each other are 5 kB, layers for CAD programs 3 kB, holes 3 kB.
    row('parts module', [at('www', 'pkg', 'build', 'shape_up_bg.wasm')], 263 * kB),
    // 5 kB of both are the gradient and the shadow on the ground.
    // The line drawing is 4 kB of both.
    // Light from all around, tiles, the section and the colour maps are 10 kB of both.
    row('view, WebGPU', [at('www', 'pkg', 'view-webgpu', 'shape_up_bg.wasm')], 187 * kB),
    row('view, WebGL2', [at('www', 'pkg', 'view-webgl2', 'shape_up_bg.wasm')], 900 * kB),
    // Of it, 0.2 kB say that the page is embedded.
    // What a lesson locks is shown as locked from the start: 0.1 kB.
    // The essentials, and telephones on their side, took 0.6 kB.
    // When light from all around is shown, flights, tiles and the choice of the colour map are 1.2 kB.
    row('first visit', [...first], 81 * kB),
    // With the circles of its panels, 9 kB.
    row('first picture', [firstPicture], 23 * kB),
    row('plots', code.filter(isPlot), 30 * kB),
    row('parts and sheets', code.filter(isOfParts), 18 * kB),
    row('variations', code.filter(isOfVariations), 9 * kB),
    // The plan that is drawn is 4 kB of it, surfaces between curves 1 kB, what calls the module of parts another 4 kB.
    row('new mesh', code.filter(isOfBegin), 13 * kB),
    row('curvature', code.filter(isOfCurvature), 9 * kB),
    row('refining', code.filter(isOfRefining), 4 * kB),
    row('presentations', code.filter(isOfPresenting), 6 * kB),
    row('links', code.filter(isOfLinks), 8 * kB),
    row('sharing, embedded', code.filter(isOfSharing), 12 * kB),
    // What lessons lock took 1 kB, how to cite 0.9 kB. Choosing files and the menu of examples, which were part of the first visit, took 1 kB.
    // What follows from the step that comes next took 0.7 kB.
    // The section, kept views, the turntable and its film are 1.7 kB.
    row('other dialogs', code.filter(isLater), 85 * kB),
    // With the embedded view before it is started, and the page about it.
    row('other pages', code.filter(isBeside), 20 * kB),
    row('licences', code.filter(isLicences), 24 * kB),
    row('files of Rhino', filesUnder(at('dist')).filter(isRhino), 1100 * kB),
  ];
  const line = (name, ...numbers) =>
    console.log(name.padEnd(22) + numbers.map((number) => String(number).padStart(11)).join(''));
  line('bytes', 'raw', 'gzip -9', 'budget');
  for (const { name, raw, gzip, budget } of rows) line(name, raw, gzip, budget);

  const over = rows.filter(({ gzip, budget }) => gzip > budget).map(({ name }) => name);
  if (over.length) throw new Problem(`Over the budget: ${over.join(', ')}`);
});
