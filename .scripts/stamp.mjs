// Skips a step whose inputs have not changed: a hash of them is kept beside Cargo's own files.

import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { root, targetFolder } from './project.mjs';

/** The files under `folder`, in a fixed order. */
export function filesUnder(folder) {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name))
    .sort();
}

/**
 * Runs `step` unless it ran with the same inputs before and `output` is still there.
 * `inputs`: paths of files, whose names and contents count; `settings`: anything else that does.
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
