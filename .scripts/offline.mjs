// The files of the site with fixed names, and its service worker with the list of all files.

import { createHash } from 'node:crypto';
import { copyFileSync, readFileSync, writeFileSync } from 'node:fs';
import { relative, sep } from 'node:path';
import { minify, transformWithOxc } from 'vite';
import { at } from './project.mjs';
import { filesUnder } from './stamp.mjs';

const SOURCE = at('www', 'app', 'service-worker.ts');
const NAMED = ['icon.svg', 'manifest.webmanifest'];
const WORKER = 'service-worker.js';
/**
 * Cached only on use: the Rhino converter; the pages about Rhino, teaching, the checks and the
 * licences, with the sources; and the examples, which are there for links from elsewhere: the page makes them
 * itself, from their list.
 */
const SELDOM = /(^|\/)(rhino|teaching|guide|checked|speed|licences|sources\/)|^examples\/(?!index)/;
/** Pictures of the first screen, of which a browser shows one. */
const FIRST = /^assets\/first-.*\.webp$/;
/** Pictures of the gallery, a third of all other files: cached together when it is opened. */
const PICTURE = /^pictures\/.*\.webp$/;
/** The view's module, of which a browser uses one variant. */
const VIEW = /^assets\/view-(webgpu|webgl2)-/;

/** Completes the site in `folder`, which contains everything else already. */
export async function writeOfflineParts(folder) {
  for (const name of NAMED) copyFileSync(at('www', name), `${folder}/${name}`);
  const source = readFileSync(SOURCE, 'utf8');
  const hash = createHash('sha256').update(source);
  const files = [];
  const pictures = [];
  /** Files of each variant of the view. */
  const views = {};
  for (const path of filesUnder(folder)) {
    const name = relative(folder, path).split(sep).join('/');
    if (name === WORKER) continue;
    hash.update(name).update('\0').update(readFileSync(path));
    // The page is requested by the name of its folder.
    const [, backend] = VIEW.exec(name) ?? [];
    if (backend) (views[backend] ??= []).push(`./${name}`);
    else if (PICTURE.test(name)) pictures.push(`./${name}`);
    else if (!SELDOM.test(name) && !FIRST.test(name))
      files.push(name === 'index.html' ? './' : `./${name}`);
  }
  const site = { version: hash.digest('hex').slice(0, 12), files, views, pictures };
  const script = await transformWithOxc(source, SOURCE);
  const { code } = await minify(WORKER, script.code, { module: false });
  writeFileSync(`${folder}/${WORKER}`, `const SITE = ${JSON.stringify(site)};\n${code}`);
}
