// The engine for pages. `shape_up.d.ts` documents all that it has.

import init from './shape_up.js';

export * from './shape_up.js';

/** Loads the module. Once is enough. */
export async function load() {
  await init({ module_or_path: new URL('./shape_up_bg.wasm', import.meta.url) });
}
