// Writes the example scenes and models, their pictures in the gallery, and the placeholder picture
// of the first one, which the page shows before it can draw.

import { mkdirSync, rmSync } from 'node:fs';
import { dirname } from 'node:path';
import { program } from './programs.mjs';
import { at } from './project.mjs';
import { run, say } from './run.mjs';
import { unlessUnchanged } from './stamp.mjs';

/** A fragment of HTML that `vite.config.mjs` inserts into the page. */
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

/** Solves the examples and writes their pictures into `www/pictures/`. */
export async function writePictures() {
  const writer = program('gallery-pictures');
  const folder = at('www', 'pictures');
  await unlessUnchanged({ name: 'pictures', inputs: [writer], output: folder }, async () => {
    say('solving the examples for their pictures');
    rmSync(folder, { recursive: true, force: true });
    await run(writer, [folder]);
  });
}

/** Writes the placeholder picture. */
export async function writeFirstPicture() {
  const writer = program('first-picture');
  const work = { name: 'first-picture', inputs: [writer], output: firstPicture };
  await unlessUnchanged(work, async () => {
    mkdirSync(dirname(firstPicture), { recursive: true });
    await run(writer, [firstPicture]);
  });
}
