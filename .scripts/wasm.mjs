// The crate as WebAssembly modules for the page, each with its JavaScript side.

import { rmSync } from 'node:fs';
import { join, relative } from 'node:path';
import { at, root, targetFolder, wasmTarget } from './project.mjs';
import { outputOf, run, say } from './run.mjs';
import { wasmBindgen } from './setup-bindgen.mjs';
import { filesUnder, unlessUnchanged } from './stamp.mjs';

/** Cargo features that are modules: the worker's, fabrication, and the page's view per backend. */
export const modules = ['solver', 'build', 'view-webgpu', 'view-webgl2'];

/**
 * Compiler flags beyond the profile. Without a limit, inlining makes a module a tenth larger and
 * hardly faster: code that must be inlined for speed is annotated. Unrolling adds a twentieth.
 */
export const sizeFlags = [
  ...['-C', 'llvm-args=-inline-threshold=25'],
  ...['-C', 'llvm-args=-unroll-runtime=false', '-C', 'llvm-args=-unroll-allow-partial=false'],
];

/** The source folders of a view module, as declared in `src/lib.rs`. */
const isOfView = (path) => /^src\/(lib\.rs|math\/|view\/|web\/(mod\.rs|page\/))/.test(path);

/** The source folders of the module for fabrication, new meshes and curvature. */
const isOfBuild = (path) =>
  /^src\/(lib\.rs|math\/|mesh\/|sparse\/|example\/|begin\/|fabricate\/|web\/(mod|begin|build|curvature)\.rs)/.test(
    path,
  );

/** Returns the sources of a module: edits of the solver recompile no view, which takes minutes. */
function sourcesOf(feature) {
  const paths = filesUnder(at('src'));
  if (feature === 'solver') return paths;
  const isPart = feature === 'build' ? isOfBuild : isOfView;
  return paths.filter((path) => isPart(relative(root, path)));
}

const isView = (feature) => feature.startsWith('view');

/**
 * Builds all modules: views and others in parallel, each kind in its own folder, since cargo builds
 * one thing at a time per folder, mostly on one core, and they share hardly any dependencies.
 */
export async function buildModules() {
  const inTurn = async (features) => {
    for (const feature of features) await buildModule(feature);
  };
  const others = modules.filter((feature) => !isView(feature));
  await Promise.all([inTurn(others), inTurn(modules.filter(isView))]);
}

/** Builds one module into `www/pkg/<feature>/`. */
export async function buildModule(feature) {
  const folder = at('www', 'pkg', feature);
  // The names of functions are most of what can be stripped from the file.
  const flags = ['--target', 'web', '--remove-name-section', '--remove-producers-section'];
  const work = {
    name: feature,
    // Cargo gives all modules the same file name and would link each of them every time.
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
    // The crate type is given here because with the two of Cargo.toml, cargo silently omits
    // link-time optimisation.
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
