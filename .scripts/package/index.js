// The engine, for pages and for Node. `shape_up.d.ts` documents all that it has.

import init from './shape_up.js';

export * from './shape_up.js';

/** Loads the module: in Node its file is read, in a browser it is fetched. Once is enough. */
export async function load() {
  const address = new URL('./shape_up_bg.wasm', import.meta.url);
  const isFile = address.protocol === 'file:';
  const source = isFile ? (await import('node:fs/promises')).readFile(address) : address;
  await init({ module_or_path: await source });
}
