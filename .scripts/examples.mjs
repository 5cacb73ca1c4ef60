// The example scenes and models, written by the command line, and the picture of the first one
// that the page shows before it can draw.

import { mkdirSync, rmSync } from 'node:fs';
import { dirname } from 'node:path';
import { program } from './programs.mjs';
import { at } from './project.mjs';
import { run } from './run.mjs';
import { unlessUnchanged } from './stamp.mjs';

/** A piece of HTML, which `vite.config.mjs` puts into the page. */
export const firstPicture = at('www', 'pkg', 'first-picture.html');

/** Writes the examples into `www/examples/`. */
export async function writeExamples() {
  const writer = program('shape-up');
  const folder = at('www', 'examples');
  await unlessUnchanged({ name: 'examples', inputs: [writer], output: folder }, async () => {
    rmSync(folder, { recursive: true, force: true });
    await run(writer, ['examples', '--out', folder]);
  });
}

/** Writes the first picture. */
export async function writeFirstPicture() {
  const writer = program('first-picture');
  const work = { name: 'first-picture', inputs: [writer], output: firstPicture };
  await unlessUnchanged(work, async () => {
    mkdirSync(dirname(firstPicture), { recursive: true });
    await run(writer, [firstPicture]);
  });
}
