// Where things are in this project, and what its lock file says.

import { readFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

/** The folder of Cargo.toml and package.json. */
export const root = dirname(dirname(fileURLToPath(import.meta.url)));

/** A path in the project, from its top. */
export const at = (...parts) => join(root, ...parts);

/** Cargo's folder for everything it builds. */
export const targetFolder = resolve(root, process.env.CARGO_TARGET_DIR ?? 'target');

/** The compile target of the page's modules. */
export const wasmTarget = 'wasm32-unknown-unknown';

/** The version of `crate` in Cargo.lock. */
export function lockedVersion(crate) {
  const lock = readFileSync(at('Cargo.lock'), 'utf8');
  const entry = lock.match(new RegExp(`name = "${crate}"\\nversion = "([^"]+)"`));
  if (!entry) throw new Error(`Cargo.lock: no package "${crate}"`);
  return entry[1];
}
