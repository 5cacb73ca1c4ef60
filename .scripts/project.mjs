// Paths of the project.

import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

/** The folder of Cargo.toml and package.json. */
export const root = dirname(dirname(fileURLToPath(import.meta.url)));

/** Returns a path relative to the top of the project. */
export const at = (...parts) => join(root, ...parts);

/** Cargo's folder for build output. */
export const targetFolder = resolve(root, process.env.CARGO_TARGET_DIR ?? 'target');

/** The command-line program as the native tests compile it; the page is compared with it. */
export const program = join(targetFolder, 'debug', 'shape-up');

/** The compile target of the page's modules. */
export const wasmTarget = 'wasm32-unknown-unknown';
