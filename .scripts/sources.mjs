// The sources that the site offers beside itself: of the library under the LGPL, as it was compiled, and
// of Shape-Up, so that whoever changes that library can build the site with it.

import { mkdirSync, readdirSync, readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { EXCEPTIONS, shippedCrates } from './licences.mjs';
import { at, root } from './project.mjs';
import { outputOf, Problem } from './run.mjs';

/** The name of the archive with the source of a crate. */
export const sourceOf = ({ name, version }) => `${name}-${version}.tar.gz`;

/** What of a folder goes into an archive, without what is built. */
function pack(archive, folder, entries, without = []) {
  const options = without.map((path) => `--exclude=${path}`);
  if (outputOf('tar', [...options, '-czf', archive, '-C', folder, ...entries]) === null)
    throw new Problem(`tar cannot write ${archive}`);
}

/** Writes them into `folder`. */
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
