// npm test: all checks, the fast ones first; at the end it prints how many tests passed.

import { existsSync, readdirSync } from 'node:fs';
import { relative } from 'node:path';
import { countTests, inexcusable } from './count.mjs';
import { at, root, targetFolder, wasmTarget } from './project.mjs';
import { main } from './run.mjs';
import { setUp } from './setup.mjs';
import { filesUnder } from './stamp.mjs';
import { step } from './step.mjs';
import { modules } from './wasm.mjs';

const tool = (name) => at('node_modules', '.bin', name);
const wasm = ['--target', wasmTarget, '--no-default-features'];
const forModule = (feature) => [...wasm, '--features', feature];
const clippy = (...args) => ['cargo', ['clippy', '--locked', ...args, '--', '-D', 'warnings']];

const styled = '**/*.{js,mjs,css,html}';
const nodeTests = ['scripts', 'page'].flatMap((folder) =>
  filesUnder(at('tests', folder))
    .filter((path) => path.endsWith('.test.mjs'))
    .map((path) => relative(root, path)),
);

/** Returns the arguments that name the browser tests of a module; empty if it has none. */
const browserTests = (feature) => {
  const [first] = feature.split('-');
  const isOne = (name) => name.startsWith(`wasm_${first}`) && name.endsWith('.rs');
  return readdirSync(at('tests')).some(isOne) ? ['--test', `wasm_${first}*`] : [];
};

/** The operators: a macro declares their modules, so cargo fmt does not find their files. */
const operators = readdirSync(at('src', 'constraint', 'kinds'))
  .filter((name) => name.endsWith('.rs'))
  .map((name) => `src/constraint/kinds/${name}`);

/** Returns the arguments of Playwright for some of its projects. */
const pageTests = (...projects) => [
  ...['test', '--config', 'tests/page/playwright.config.mjs', '--no-deps'],
  ...projects.map((project) => `--project=${project}`),
];

/** The steps: title, program with arguments, and the kind of test counts it prints, if any. */
const steps = [
  { title: 'format of Rust', run: ['cargo', ['fmt', '--check', '--', ...operators]] },
  { title: 'format of the page', run: [tool('prettier'), ['--check', styled]] },
  {
    title: 'lints of JavaScript',
    run: [tool('eslint'), ['--config', '.scripts/eslint.config.mjs', '--max-warnings', '0', '.']],
  },
  {
    title: 'tests of the scripts, and of the page without a browser',
    run: ['node', ['--test', '--test-reporter=tap', ...nodeTests]],
    count: 'node',
  },
  // The native checks include the view, without a GPU.
  { title: 'lints of Rust, native', run: clippy('--all-targets', '--features', 'view') },
  ...modules.map((feature) => ({
    title: `lints of Rust, ${feature} module`,
    run: clippy('--lib', ...browserTests(feature), ...forModule(feature)),
  })),
  {
    // With all features, so that links between all rooms resolve.
    title: 'documentation',
    run: ['cargo', ['doc', '--locked', '--no-deps', ...forModule(modules.join(','))]],
    env: { RUSTDOCFLAGS: '-D warnings' },
  },
  {
    title: 'native tests',
    run: ['cargo', ['test', '--locked', '--no-fail-fast', '--features', 'view']],
    count: 'cargo',
  },
  ...modules
    .filter((feature) => browserTests(feature).length)
    .map((feature) => ({
      title: `tests of the ${feature} module in the browser`,
      run: [
        'cargo',
        ['test', '--locked', '--no-fail-fast', ...forModule(feature), ...browserTests(feature)],
      ],
      env: { CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER: 'node .scripts/wasm-test-runner.mjs' },
      count: 'cargo',
    })),
  { title: 'build of the site', run: ['node', ['.scripts/build.mjs']] },
  {
    // After the build, which it measures.
    title: 'benchmark at its smallest size',
    run: ['node', ['--test', '--test-reporter=tap', 'tests/bench/bench.test.mjs']],
    count: 'node',
  },
  {
    // After the build, which writes the declarations of the modules.
    title: 'types of the page',
    run: [tool('tsc'), ['--pretty', 'false', '--project', '.scripts/tsconfig.json']],
  },
  {
    // Before the others: it measures time, and needs the machine for itself.
    title: 'response time of drags',
    run: [tool('playwright'), pageTests('alone')],
    count: 'playwright',
  },
  {
    title: 'tests of the page in the browser',
    run: [tool('playwright'), pageTests('desktop', 'both', 'phone')],
    count: 'playwright',
  },
  { title: 'sizes', run: ['node', ['.scripts/sizes.mjs']], show: true },
];

/** Number of tests that may be flaky without an excuse: shared hosts stall at times. */
const MOST_FLAKY = 2;

const inWords = ({ passed, failed, skipped, flaky }) =>
  `${passed} passed, ${failed} failed, ${skipped} skipped, ${flaky} flaky`;

await main(async () => {
  // In a fresh clone, recording what the next build could reuse would cost a fifth of this one.
  if (!existsSync(targetFolder)) process.env.CARGO_INCREMENTAL ??= '0';
  await setUp({ checks: true });
  const sum = { passed: 0, failed: 0, skipped: 0, flaky: 0 };
  for (const { title, run, env, count, show } of steps) {
    const { ok, output } = await step(title, ...run, env);
    if (count) {
      const { passed, failed, skipped, flaky } = countTests(count, output);
      console.log(
        `    ${inWords({ passed, failed, skipped: skipped.length, flaky: flaky.length })}`,
      );
      sum.passed += passed;
      sum.failed += failed;
      sum.skipped += skipped.length;
      sum.flaky += flaky.length;
      const [unrun, unsteady] = [inexcusable(skipped), inexcusable(flaky)];
      for (const test of unrun) console.log(`    skipped without a reason: ${test}`);
      for (const test of unsteady) console.log(`    flaky without a reason: ${test}`);
      // How they failed at first: Playwright numbers its reports.
      if (ok && unsteady.length > 0) console.log(output.slice(output.search(/^ +1\) /m)));
      if (unrun.length > 0 || unsteady.length > MOST_FLAKY) process.exitCode = 1;
    }
    if (show && ok) console.log(output);
    if (!ok) {
      // A step without tests of its own counts as one failure.
      sum.failed = Math.max(sum.failed, 1);
      process.exitCode = 1;
      break;
    }
  }
  console.log(inWords(sum));
});
