// wasm-bindgen: writes the JavaScript side of a compiled module. The crate has this as a library; a
// small program of ours calls it, which compiles in a fraction of the time of its own command
// line.

import { join } from 'node:path';
import { at, targetFolder } from './project.mjs';
import { run } from './run.mjs';

const manifest = at('.scripts', 'bindgen', 'Cargo.toml');
const folder = join(targetFolder, 'bindgen');

/** Builds the program, which takes a fraction of a second if it is built already. */
export const buildBindgen = () =>
  run('cargo', [
    ...['build', '--quiet', '--locked'],
    ...['--manifest-path', manifest, '--target-dir', folder],
  ]);

/**
 * Writes the JavaScript side of `module` and the module for it into `folder`; of a test program,
 * what its tests are called by.
 */
export const bindgen = (module, into, { test = false } = {}) =>
  run(join(folder, 'debug', 'bindgen'), [module, into, ...(test ? ['--test'] : [])]);
