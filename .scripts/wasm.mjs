// The crate as two WebAssembly modules for the page, each with its JavaScript side.

import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { at, lockedVersion, targetFolder, wasmTarget } from './project.mjs';
import { run, say } from './run.mjs';
import { wasmBindgen } from './setup-bindgen.mjs';
import { unlessUnchanged } from './stamp.mjs';

/** The Cargo features that are modules: the worker's and the page's. */
export const modules = ['solver', 'view'];

/** Builds one of them into `www/pkg/<feature>/`. */
export async function buildModule(feature) {
  say(`compiling the ${feature} module`);
  // The crate type is named here because with the two of Cargo.toml cargo leaves out the
  // link-time optimisation without a word.
  await run('cargo', [
    ...['rustc', '--locked', '--lib', '--release', '--crate-type', 'cdylib'],
    ...['--target', wasmTarget, '--no-default-features', '--features', feature],
  ]);
  const compiled = join(targetFolder, wasmTarget, 'release', 'shape_up.wasm');
  const folder = at('www', 'pkg', feature);
  // The names of functions are most of what could be left out of the file.
  const flags = ['--target', 'web', '--remove-name-section', '--remove-producers-section'];
  await unlessUnchanged(
    {
      name: feature,
      inputs: [compiled],
      settings: [flags, lockedVersion('wasm-bindgen')],
      output: join(folder, 'shape_up_bg.wasm'),
    },
    async () => {
      rmSync(folder, { recursive: true, force: true });
      await run(wasmBindgen, [...flags, '--out-dir', folder, compiled]);
    },
  );
}
