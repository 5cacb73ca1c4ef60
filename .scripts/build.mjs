// npm run build: builds the static site in dist/.

import { fileURLToPath } from 'node:url';
import { writeExamples } from './examples.mjs';
import { buildPrograms } from './programs.mjs';
import { main } from './run.mjs';
import { setUp } from './setup.mjs';
import { bundleSite } from './site.mjs';
import { buildModules } from './wasm.mjs';

/** Builds everything that the page loads, in `www/`. */
export async function buildParts() {
  await buildModules();
  await buildPrograms();
  await writeExamples();
}

/** Builds the site, in `dist/`. */
export async function build() {
  await buildParts();
  await bundleSite();
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  await main(async () => {
    await setUp({ checks: false });
    await build();
  });
}
