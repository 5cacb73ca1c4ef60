// What `npm test` runs, in two lanes side by side: a machine has at least two cores, and compilers
// and linkers often use one. `npm run check` runs the steps that need no browser.

import { existsSync, readdirSync } from 'node:fs';
import { relative } from 'node:path';
import { at, program, root } from './project.mjs';
import { filesUnder } from './stamp.mjs';
import { moduleArguments, modules, sourcesOf } from './wasm.mjs';

const tool = (name) => at('node_modules', '.bin', name);
const script = (name, ...words) => ['node', [`.scripts/${name}.mjs`, ...words]];
/** Node's own tests; tsx reads the modules of the page, which are in TypeScript. */
const node = (tests, ...before) => {
  const imports = ['tsx', './tests/page/fetch-files.mjs', ...before];
  const words = imports.flatMap((name) => ['--import', name]);
  return ['node', [...words, '--test', '--test-reporter=tap', ...tests]];
};

/**
 * Cargo with Clippy in place of the compiler, as `cargo clippy -- -D warnings` calls it, except that it
 * also compiles: what is built for tests is linted on the way, and its dependencies are compiled once
 * instead of being checked as well. Clippy leaves out optimisations before those of LLVM; the tests
 * run as fast.
 */
const linted = {
  RUSTC_WORKSPACE_WRAPPER: 'clippy-driver',
  CLIPPY_ARGS: '-Dwarnings__CLIPPY_HACKERY__',
};
/** This crate without optimisation, for tests that are soon over; dependencies as always. */
const unoptimised = { CARGO_PROFILE_DEV_OPT_LEVEL: '0' };

const nodeTests = ['scripts', 'page'].flatMap((folder) =>
  filesUnder(at('tests', folder))
    .filter((path) => /\.test\.(mjs|ts)$/.test(path))
    .map((path) => relative(root, path)),
);
/** Those that ask the engine, and come after it is built. */
const asksEngine = (path) => path.startsWith('tests/page/engine/');

/** The operators: a macro declares their modules, so cargo fmt does not find their files. */
const operators = readdirSync(at('src', 'constraint', 'kinds'))
  .filter((name) => name.endsWith('.rs'))
  .map((name) => `src/constraint/kinds/${name}`);

/** Returns the arguments of Playwright for some of its projects, with those of the command. */
const pageTests = (...projects) => [
  ...['test', '--config', 'tests/page/playwright.config.ts', '--no-deps'],
  ...projects.map((project) => `--project=${project}`),
  ...process.argv.slice(3),
];

/** How everything is compiled and run. */
const common = () =>
  [
    ...['.scripts', '.cargo', '.clippy.toml', '.rustfmt.toml'],
    ...['Cargo.toml', 'Cargo.lock', 'package-lock.json'],
  ].map((name) => at(name));
/** Foreign meshes and expected results, which a clone of the repository alone has not. */
const shared = at('..', 'shared');
/**
 * What decides over the tests of Rust, which also read the results that the gallery shows, the script
 * for Rhino and the material beside the project. Steps with `inputs` are skipped while these are
 * unchanged; what is read of the rest, by `tests/scripts`, is looked at every time.
 */
const rust = () => [
  ...common(),
  ...['src', 'www/pictures', 'www/rhino'].map((name) => at(name)),
  ...filesUnder(at('tests')).filter(
    (path) => !/^tests\/(page|scripts)\//.test(relative(root, path)),
  ),
  ...(existsSync(shared) ? [shared] : []),
];
/**
 * What decides over the tests of the page: the built site without the sources that it offers and the
 * package beside it, and the program with which it is compared.
 */
export const site = (built = filesUnder(at('dist'))) => [
  ...common(),
  at('tests', 'page'),
  program,
  ...built.filter((path) => !/^dist\/(sources|npm)\//.test(relative(root, path))),
];

const module = (feature) => ({ title: `the ${feature} module`, run: script('modules', feature) });

const [words, , ...views] = modules;

/** The program with the tests of a module; that of words is tested natively and in Node. */
const testsOf = (feature) => (feature === words ? [] : ['--test', `wasm_${feature.split('-')[0]}`]);

const browserTests = (feature) => ({
  title: `tests of the ${feature} module in the browser`,
  run: ['cargo', ['test', ...moduleArguments(feature), ...testsOf(feature)]],
  count: 'cargo',
  inputs: () => [
    ...common(),
    ...sourcesOf(feature),
    ...['wasm_engine.rs', 'wasm_view.rs', 'data', 'support'].map((name) => at('tests', name)),
  ],
});

/** Its tests come before the next module, which takes its place as the library of this target. */
const engine = [module('engine'), browserTests('engine')];
/** Those of the last view first. Beside a compiler, drawing in software takes five times as long. */
const viewTests = views.toReversed().map(browserTests);

/** Formats of what is not Rust, and tests that need no module but that of words. */
const texts = [
  {
    title: 'format of the page',
    run: [tool('prettier'), ['--check', '**/*.{ts,tsx,mjs,css,html}']],
  },
  module(words),
  {
    title: 'tests of the scripts, and of the page without a browser',
    run: node(
      nodeTests.filter((path) => !asksEngine(path)),
      './tests/page/without-engine.mjs',
    ),
    count: 'node',
  },
];

/** All features at once: what they depend on is checked once, for lints and documentation. */
const withAll = moduleArguments([...modules, 'cli'].join(','));

const compiled = [
  {
    // With types: after the modules, whose declarations it reads, as the next step does.
    title: 'lints of the page',
    run: [tool('eslint'), ['--config', '.scripts/eslint.config.mjs', '--max-warnings', '0', '.']],
  },
  {
    title: 'types of the page',
    run: [tool('tsc'), ['--pretty', 'false', '--project', '.scripts/tsconfig.json']],
  },
  {
    // What is compiled natively is linted there. With all features at once, what one module alone does
    // not use is not found; its build prints a warning.
    title: 'lints of Rust in the browser',
    run: [
      'cargo',
      ['clippy', '--lib', ...modules.flatMap(testsOf), ...withAll, '--', '-D', 'warnings'],
    ],
  },
  {
    // With all features, so that links between all rooms resolve.
    title: 'documentation',
    run: ['cargo', ['doc', '--lib', '--no-deps', ...withAll]],
    env: { RUSTDOCFLAGS: '-D warnings' },
  },
];

/** With the view, which needs no GPU to be tested. */
const nativeArguments = ['--locked', '--features', 'view'];

const native = [
  { title: 'format of Rust', run: ['cargo', ['fmt', '--check', '--', ...operators]] },
  {
    title: 'native tests beside the code',
    run: ['cargo', ['test', '--no-fail-fast', ...nativeArguments, '--lib']],
    env: { ...linted, ...unoptimised },
    count: 'cargo',
    inputs: rust,
  },
  {
    title: 'native tests',
    // With what they print: some say that they have nothing to look at.
    run: [
      'cargo',
      ['test', '--no-fail-fast', ...nativeArguments, '--test', 'native', '--', '--show-output'],
    ],
    env: linted,
    count: 'cargo',
    inputs: rust,
  },
];

const built = [
  { title: 'build of the site', run: script('build') },
  { title: 'sizes', run: script('sizes'), show: true },
];

/** Builds the program that the native tests run, with which the benchmark and the page are compared. */
const programBuilt = {
  title: 'the native program',
  // As the tests compile it: by itself it would be compiled anew, with fewer features of its crates.
  run: ['cargo', ['test', '--no-run', ...nativeArguments, '--test', 'native']],
  env: linted,
};

const bench = [
  {
    title: 'tests of the page with the engine, without a browser',
    run: node(nodeTests.filter(asksEngine)),
    count: 'node',
  },
  {
    title: 'the package, installed in an empty folder',
    run: node(['tests/package/package.test.mjs']),
    count: 'node',
    inputs: () => [...common(), at('www', 'pkg', 'engine'), at('tests', 'package')],
  },
  {
    title: 'benchmark at its smallest size',
    run: node(['tests/bench/bench.test.mjs']),
    count: 'node',
    inputs: rust,
  },
];

/** After everything else: they measure time, or need both cores. */
const page = [
  {
    title: 'response times of the page',
    run: [tool('playwright'), [...pageTests('alone'), '--workers=1']],
    count: 'playwright',
    inputs: site,
  },
  {
    title: 'tests of the page in the browser',
    run: [tool('playwright'), pageTests('desktop', 'both', 'phone')],
    count: 'playwright',
    inputs: site,
  },
];

/** Only `npm run test:long` has it; all other tests of the page run in Chromium. */
const otherBrowsers = {
  title: 'a story in Firefox and WebKit',
  // Node 20 has a client of web sockets, but not without this.
  run: ['node', ['--experimental-websocket', ...node(['tests/browsers/story.test.mjs'])[1]]],
  count: 'node',
};

const all = [
  [[...texts, ...engine, ...views.map(module), ...compiled, ...built], native],
  [[programBuilt, ...bench, ...viewTests, ...page]],
];

const declarations = {
  title: 'modules whose types may have changed',
  run: script('modules', '--declarations'),
};

/** The stages of each command, one after another; the lanes of a stage run side by side. */
export const stages = {
  check: [[[...texts, declarations, ...compiled], native]],
  site: [[[...engine, ...views.map(module), ...viewTests, ...built, programBuilt, ...bench]]],
  page: [[[programBuilt, ...page]]],
  test: all,
  long: [...all, [[otherBrowsers]]],
};
