// The native programs that the build runs: the command line, and the one that draws the page's
// first picture.

import { join } from 'node:path';
import { targetFolder } from './project.mjs';
import { run, say } from './run.mjs';

/** The path of one of them, once they are built. */
export const program = (name) => join(targetFolder, 'debug', name);

/** Builds all of them, as `npm test` does. */
export async function buildPrograms() {
  say('building the programs that write the examples and the first picture');
  await run('cargo', ['build', '--locked', '--bins', '--features', 'view']);
}
