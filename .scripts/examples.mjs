// The example scenes and models, written by the command line.

import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { at, targetFolder } from './project.mjs';
import { run, say } from './run.mjs';
import { unlessUnchanged } from './stamp.mjs';

/** Writes them into `www/examples/`. */
export async function writeExamples() {
  say('building the command line, which writes the examples');
  await run('cargo', ['build', '--locked', '--bin', 'shape-up']);
  const program = join(targetFolder, 'debug', 'shape-up');
  const folder = at('www', 'examples');
  await unlessUnchanged({ name: 'examples', inputs: [program], output: folder }, async () => {
    rmSync(folder, { recursive: true, force: true });
    await run(program, ['examples', '--out', folder]);
  });
}
