// The native programs that the build runs: the command line, and those that draw pictures.

import { join } from 'node:path';
import { targetFolder } from './project.mjs';
import { run, say } from './run.mjs';

/** Returns the path of a program, once built. */
export const program = (name) => join(targetFolder, 'debug', name);

/** Builds all programs, with the options of `npm test`. */
export async function buildPrograms() {
  say('building the programs that write the examples and the first picture');
  await run('cargo', ['build', '--locked', '--bins', '--features', 'view']);
}
