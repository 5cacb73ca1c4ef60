// The crate as WebAssembly modules for the page, each with its JavaScript side.

import { readFileSync, rmSync } from 'node:fs';
import { join, relative } from 'node:path';
import { bindgen, buildBindgen } from './bindgen.mjs';
import { at, root, targetFolder, wasmTarget } from './project.mjs';
import { outputOf, run, say } from './run.mjs';
import { filesUnder, stampOf, unlessUnchanged } from './stamp.mjs';

/** Cargo features that are modules: the page's words, the workers' engine, and the page's view for each backend. */
export const modules = ['words', 'engine', 'view-webgpu', 'view-webgl2'];

/** Arguments of cargo that select a module. */
export const moduleArguments = (feature) => [
  ...['--locked', '--release', '--target', wasmTarget],
  ...['--no-default-features', '--features', feature],
];

/** The source folders of the page's modules, as declared in `src/lib.rs`. */
const OF_WORDS = /^src\/(lib\.rs|math\/|words\/|web\/(mod|words)\.rs)/;
const OF_VIEW = /^src\/(lib\.rs|math\/|view\/|web\/(mod\.rs|page\/))/;

/** Returns the sources of a module: edits of the engine recompile neither words nor views. */
export function sourcesOf(feature) {
  const paths = filesUnder(at('src'));
  if (feature === 'engine') return paths;
  const parts = feature === 'words' ? OF_WORDS : OF_VIEW;
  return paths.filter((path) => parts.test(relative(root, path)));
}

/** What else decides over a module. */
const tools = () => ({
  paths: ['Cargo.toml', 'Cargo.lock', '.cargo/config.toml', '.scripts/bindgen/main.rs'].map(
    (name) => at(name),
  ),
  settings: [outputOf('rustc', ['--version'])],
});

/** What decides over the TypeScript that a module declares: files that declare any, and `src/web`. */
function declarationsOf(feature) {
  const declares = (path) =>
    relative(root, path).startsWith(join('src', 'web')) ||
    /tsify|wasm_bindgen/i.test(readFileSync(path, 'utf8'));
  const { paths, settings } = tools();
  const inputs = [...sourcesOf(feature).filter(declares), ...paths];
  return { name: `${feature}-declarations`, inputs, settings };
}

/** Builds modules, or all of them. */
export async function buildModules(wanted = modules) {
  await buildBindgen();
  for (const feature of wanted) await buildModule(feature);
}

/**
 * Builds modules unless those that are there declare the same to TypeScript: a change of what no
 * file with declarations says is not waited for before types are checked.
 */
export async function buildDeclarations(wanted = modules) {
  for (const feature of wanted) {
    const output = join(at('www', 'pkg', feature), 'shape_up.d.ts');
    await unlessUnchanged({ ...declarationsOf(feature), output }, () => buildModules([feature]));
  }
}

/** Builds one module into `www/pkg/<feature>/`. */
export async function buildModule(feature) {
  const folder = at('www', 'pkg', feature);
  const { paths, settings } = tools();
  const work = {
    name: feature,
    // Cargo gives all modules the same file name and would link each of them every time.
    inputs: [...sourcesOf(feature), ...paths],
    settings,
    output: join(folder, 'shape_up_bg.wasm'),
  };
  await unlessUnchanged(work, async () => {
    say(`compiling the ${feature} module`);
    await run('cargo', ['build', '--lib', ...moduleArguments(feature)]);
    rmSync(folder, { recursive: true, force: true });
    await bindgen(join(targetFolder, wasmTarget, 'release', 'shape_up.wasm'), folder);
    stampOf(declarationsOf(feature)).store(true);
  });
}
