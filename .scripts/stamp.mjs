// Skips work whose inputs have not changed: their hash is stored in the target folder.

import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { root, targetFolder } from './project.mjs';

/** Returns the files under `folder`, in a fixed order. */
export function filesUnder(folder) {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name))
    .sort();
}

/**
 * Returns a stamp of some inputs. `inputs`: paths of files and folders, compared by name and
 * content; `settings`: anything else that matters.
 */
export function stampOf({ name, inputs, settings = [] }) {
  const hash = createHash('sha256').update(JSON.stringify(settings));
  const files = inputs.flatMap((path) => (statSync(path).isDirectory() ? filesUnder(path) : path));
  for (const path of files)
    hash.update(relative(root, path)).update('\0').update(readFileSync(path));
  const key = hash.digest('hex');
  const file = join(targetFolder, 'stamps', name);
  return {
    /** What was stored with the same inputs; undefined if there is nothing. */
    stored() {
      if (!existsSync(file)) return undefined;
      const [before, result] = readFileSync(file, 'utf8').split('\n');
      return before === key ? JSON.parse(result) : undefined;
    },
    store(result) {
      mkdirSync(join(targetFolder, 'stamps'), { recursive: true });
      writeFileSync(file, `${key}\n${JSON.stringify(result)}`);
    },
  };
}

/** Runs `step` unless it has run with the same inputs and `output` still exists. */
export async function unlessUnchanged({ output, ...of }, step) {
  const stamp = stampOf(of);
  if (existsSync(output) && stamp.stored()) return;
  await step();
  stamp.store(true);
}
