// The sources that the site offers: of the library under the LGPL, as compiled, and of Shape-Up, so
// that the site can be built with a modified library.

import { mkdirSync, readdirSync, readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { EXCEPTIONS, shippedCrates } from './licences.mjs';
import { at, root } from './project.mjs';
import { outputOf, Problem } from './run.mjs';

/** Returns the name of the archive with the source of a crate. */
export const sourceOf = ({ name, version }) => `${name}-${version}.tar.gz`;

/** Packs entries of a folder into an archive, without build output. */
function pack(archive, folder, entries, without = []) {
  const options = without.map((path) => `--exclude=${path}`);
  if (outputOf('tar', [...options, '-czf', archive, '-C', folder, ...entries]) === null)
    throw new Problem(`tar cannot write ${archive}`);
}

/** Writes the archives into `folder`. */
export function writeSources(folder) {
  mkdirSync(folder, { recursive: true });
  const built = readFileSync(at('.gitignore'), 'utf8')
    .split('\n')
    .map((line) => line.replace(/^\//, ''))
    .filter((line) => line);
  const own = readdirSync(root).filter((name) => name !== '.git' && !built.includes(name));
  pack(join(folder, 'shape-up.tar.gz'), root, own, built);
  for (const crate of shippedCrates().filter(({ name }) => name in EXCEPTIONS))
    pack(join(folder, sourceOf(crate)), dirname(crate.folder), [basename(crate.folder)]);
}
