// The engine for Node. `shape_up.d.ts` documents all that it has.

import { readFile } from 'node:fs/promises';
import init from './shape_up.js';

export * from './shape_up.js';

/** Loads the module. Once is enough. */
export async function load() {
  const file = await readFile(new URL('./shape_up_bg.wasm', import.meta.url));
  await init({ module_or_path: file });
}
