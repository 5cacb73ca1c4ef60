// The sources that the site offers: of the library under the LGPL, as compiled, and of Shape-Up, so
// that the site can be built with a modified library.

import { existsSync, mkdirSync, readdirSync, readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { EXCEPTIONS, shippedCrates } from './licences.mjs';
import { root } from './project.mjs';
import { outputOf, Problem } from './run.mjs';

/** Returns the name of the archive with the source of a crate. */
export const sourceOf = ({ name, version }) => `${name}-${version}.tar.gz`;

/** Packs entries of a folder into an archive, without build output. */
function pack(archive, folder, entries, without = []) {
  const options = without.map((path) => `--exclude=${path}`);
  if (outputOf('tar', [...options, '-czf', archive, '-C', folder, ...entries]) === null)
    throw new Problem(`tar cannot write ${archive}`);
}

/**
 * Returns the own sources in a folder, and build output among them: the files of its repository, so
 * that nothing else that lies there is published; unpacked from the archive it has none, and all is.
 */
export function ownSources(folder) {
  if (existsSync(join(folder, '.git'))) {
    const tracked = outputOf('git', ['-C', folder, 'ls-files', '-z']);
    if (tracked === null) throw new Problem(`git cannot list the files of ${folder}`);
    const files = tracked.split('\0').filter((path) => path && existsSync(join(folder, path)));
    return { entries: files, built: [] };
  }
  const ignored = readFileSync(join(folder, '.gitignore'), 'utf8').split('\n');
  const built = ignored.map((line) => line.replace(/^\//, '')).filter((line) => line);
  const entries = readdirSync(folder).filter((name) => name !== '.git' && !built.includes(name));
  return { entries, built };
}

/** Writes the archives into `folder`. */
export function writeSources(folder) {
  mkdirSync(folder, { recursive: true });
  const { entries, built } = ownSources(root);
  pack(join(folder, 'shape-up.tar.gz'), root, entries, built);
  for (const crate of shippedCrates().filter(({ name }) => name in EXCEPTIONS))
    pack(join(folder, sourceOf(crate)), dirname(crate.folder), [basename(crate.folder)]);
}
