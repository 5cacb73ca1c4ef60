// Writes the example scenes and models.

import { rmSync } from 'node:fs';
import { program } from './programs.mjs';
import { at } from './project.mjs';
import { run } from './run.mjs';
import { unlessUnchanged } from './stamp.mjs';

/** Writes the examples into `www/examples/`. */
export async function writeExamples() {
  const writer = program('shape-up');
  const folder = at('www', 'examples');
  await unlessUnchanged({ name: 'examples', inputs: [writer], output: folder }, async () => {
    rmSync(folder, { recursive: true, force: true });
    await run(writer, ['examples', '--out', folder]);
  });
}
