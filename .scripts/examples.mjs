// Writes the example scenes and models, by the engine that the page loads.

import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { at } from './project.mjs';
import { unlessUnchanged } from './stamp.mjs';

/** Writes the examples into `www/examples/`. */
export async function writeExamples() {
  const engine = (name) => at('www', 'pkg', 'engine', name);
  const folder = at('www', 'examples');
  const inputs = [engine('shape_up_bg.wasm')];
  await unlessUnchanged({ name: 'examples', inputs, output: folder }, async () => {
    const { initSync, exampleFiles } = await import(pathToFileURL(engine('shape_up.js')).href);
    initSync({ module: readFileSync(engine('shape_up_bg.wasm')) });
    rmSync(folder, { recursive: true, force: true });
    mkdirSync(folder, { recursive: true });
    for (const [name, text] of exampleFiles()) writeFileSync(join(folder, name), text);
  });
}
