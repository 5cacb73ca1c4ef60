// Skips a build step whose inputs have not changed: their hash is stored in the target folder.

import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
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
 * Runs `step` unless it has run with the same inputs and `output` still exists. `inputs`: paths of
 * files, compared by name and content; `settings`: anything else that matters.
 */
export async function unlessUnchanged({ name, inputs, settings = [], output }, step) {
  const hash = createHash('sha256').update(JSON.stringify(settings));
  for (const path of inputs)
    hash.update(relative(root, path)).update('\0').update(readFileSync(path));
  const key = hash.digest('hex');

  const stamp = join(targetFolder, 'stamps', name);
  if (existsSync(output) && existsSync(stamp) && readFileSync(stamp, 'utf8') === key) return;
  await step();
  mkdirSync(join(targetFolder, 'stamps'), { recursive: true });
  writeFileSync(stamp, key);
}
