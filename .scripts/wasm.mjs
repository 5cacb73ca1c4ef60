// The crate as WebAssembly modules for the page, each with its JavaScript side.

import { rmSync } from 'node:fs';
import { join, relative } from 'node:path';
import { at, root, targetFolder, wasmTarget } from './project.mjs';
import { outputOf, run, say } from './run.mjs';
import { wasmBindgen } from './setup-bindgen.mjs';
import { filesUnder, unlessUnchanged } from './stamp.mjs';

/** The Cargo features that are modules: the worker's, that of parts, and the page's for each backend. */
export const modules = ['solver', 'build', 'view-webgpu', 'view-webgl2'];

/**
 * What the compiler is told beside the profile. Without a limit it copies functions into their callers
 * until a module is a tenth larger, and hardly faster: what has to be in place for speed says so itself.
 * So it is with the bodies of loops that it repeats, which is another twentieth.
 */
export const sizeFlags = [
  ...['-C', 'llvm-args=-inline-threshold=25'],
  ...['-C', 'llvm-args=-unroll-runtime=false', '-C', 'llvm-args=-unroll-allow-partial=false'],
];

/** The rooms of `src/` that a view is compiled from; `src/lib.rs` says so. */
const isOfView = (path) => /^src\/(lib\.rs|math\/|view\/|web\/(mod\.rs|page\/))/.test(path);

/** The rooms that the module of parts, of meshes to begin with and of curvature is compiled from. */
const isOfBuild = (path) =>
  /^src\/(lib\.rs|math\/|mesh\/|sparse\/|example\/|begin\/|fabricate\/|web\/(mod|begin|build|curvature)\.rs)/.test(
    path,
  );

/** The sources of a module: an edit of the solver compiles no view anew, which takes minutes. */
function sourcesOf(feature) {
  const paths = filesUnder(at('src'));
  if (feature === 'solver') return paths;
  const isPart = feature === 'build' ? isOfBuild : isOfView;
  return paths.filter((path) => isPart(relative(root, path)));
}

const isView = (feature) => feature.startsWith('view');

/**
 * Builds all of them: views and others side by side, each kind in a folder of its own, since cargo builds one
 * thing at a time in a folder, most of it on one core, and they share hardly any dependencies.
 */
export async function buildModules() {
  const inTurn = async (features) => {
    for (const feature of features) await buildModule(feature);
  };
  const others = modules.filter((feature) => !isView(feature));
  await Promise.all([inTurn(others), inTurn(modules.filter(isView))]);
}

/** Builds one of them into `www/pkg/<feature>/`. */
export async function buildModule(feature) {
  const folder = at('www', 'pkg', feature);
  // The names of functions are most of what could be left out of the file.
  const flags = ['--target', 'web', '--remove-name-section', '--remove-producers-section'];
  const work = {
    name: feature,
    // Cargo gives all modules the same file name, so it would link each anew every time.
    inputs: [
      ...sourcesOf(feature),
      ...['Cargo.toml', 'Cargo.lock', '.cargo/config.toml'].map((name) => at(name)),
    ],
    settings: [flags, sizeFlags, outputOf('rustc', ['--version'])],
    output: join(folder, 'shape_up_bg.wasm'),
  };
  await unlessUnchanged(work, async () => {
    say(`compiling the ${feature} module`);
    const target = isView(feature) ? join(targetFolder, 'views') : targetFolder;
    // The crate type is named here because with the two of Cargo.toml cargo leaves out the
    // link-time optimisation without a word.
    await run('cargo', [
      ...['rustc', '--locked', '--lib', '--release', '--crate-type', 'cdylib'],
      ...['--target', wasmTarget, '--no-default-features', '--features', feature],
      ...['--target-dir', target, '--', ...sizeFlags],
    ]);
    rmSync(folder, { recursive: true, force: true });
    const compiled = join(target, wasmTarget, 'release', 'shape_up.wasm');
    await run(wasmBindgen, [...flags, '--out-dir', folder, compiled]);
  });
}
