// npm test: the checks, the fast ones first; at the end it prints how many tests passed.
// npm run check: those that need no browser. npm run test:long: with the long versions of tests,
// and with those that only the night runs.

import { existsSync } from 'node:fs';
import { stages } from './checks.mjs';
import { findBrowser } from './browser.mjs';
import { countTests, inexcusable, isToRunAgain } from './count.mjs';
import { targetFolder } from './project.mjs';
import { main, outputOf, Problem } from './run.mjs';
import { setUp } from './setup.mjs';
import { setUpOtherBrowsers } from './setup-browser.mjs';
import { stampOf } from './stamp.mjs';
import { step } from './step.mjs';

/** Number of tests that may be flaky without an excuse: shared hosts stall at times. */
const MOST_FLAKY = 2;

const none = { passed: 0, failed: 0, skipped: 0, flaky: 0 };
let sum = none;
/** The versions of the tools that are there. */
let found = [];

const add = (a, b) => Object.fromEntries(Object.keys(none).map((key) => [key, a[key] + b[key]]));

const inWords = ({ passed, failed, skipped, flaky }) =>
  `${passed} passed, ${failed} failed, ${skipped} skipped, ${flaky} flaky`;

/** What runs the steps, beside what the lock files name; null for a browser that is not there. */
async function tools() {
  const browser = await findBrowser();
  const versions = [process.version, outputOf('rustc', ['--version'])];
  return [...versions, browser && outputOf(browser, ['--version'])];
}

/** Prints what is to be said of the tests of a step; returns their numbers, and whether to repeat it. */
function counted(kind, { ok, output }) {
  const tests = countTests(kind, output);
  const { passed, failed, skipped, flaky } = tests;
  const numbers = { passed, failed, skipped: skipped.length, flaky: flaky.length };
  const [unrun, unsteady] = [inexcusable(skipped), inexcusable(flaky)];
  if (unrun.length > 0 || unsteady.length > MOST_FLAKY) process.exitCode = 1;
  console.log(`    ${inWords(numbers)}`);
  for (const test of unrun) console.log(`    skipped without a reason: ${test}`);
  for (const test of unsteady) console.log(`    flaky without a reason: ${test}`);
  // How they failed at first: Playwright numbers its reports.
  const report = output.search(/^ +1\) /m);
  if (ok && unsteady.length > 0 && report >= 0) console.log(output.slice(report));
  return { numbers, again: isToRunAgain(tests) };
}

/** Runs a step, unless it has passed with the same inputs; resolves with whether it passed. */
async function perform({ title, run, env, count, show, inputs }) {
  const name = title.replaceAll(/\W+/g, '-');
  const settings = [run, process.env.LONG, found];
  const stamp = inputs && stampOf({ name, inputs: inputs(), settings });
  const before = stamp?.stored();
  if (before) {
    console.log(`- ${title}: unchanged since it passed, ${inWords(before)}`);
    sum = add(sum, before);
    return true;
  }
  const done = await step(title, ...run, env);
  const { numbers, again } = count ? counted(count, done) : { numbers: none, again: false };
  sum = add(sum, numbers);
  if (show && done.ok) console.log(done.output);
  if (done.ok && !again) stamp?.store(numbers);
  return done.ok;
}

/** Whether a step has failed: no step begins after that. */
let failed = false;

/** Runs the steps of a lane one after another. */
async function lane(steps) {
  for (const one of steps) if (!failed) failed = !(await perform(one)) || failed;
}

await main(async () => {
  const [command = 'test'] = process.argv.slice(2);
  if (!(command in stages)) throw new Problem(`usage: test.mjs ${Object.keys(stages).join('|')}`);
  if (command === 'long') Object.assign(process.env, { LONG: '1', SHAPE_UP_FUZZ: '20' });
  // In a fresh clone, recording what the next build could reuse would cost a fifth of this one.
  if (!existsSync(targetFolder)) process.env.CARGO_INCREMENTAL ??= '0';
  const begun = performance.now();
  await setUp({ checks: true, browser: command !== 'check' });
  if (command === 'long') await setUpOtherBrowsers();
  found = await tools();
  console.log(`- set-up\n    ok (${((performance.now() - begun) / 1000).toFixed(1)} s)`);
  for (const lanes of stages[command]) await Promise.all(lanes.map(lane));
  if (failed) {
    // A step without tests of its own counts as one failure.
    sum = { ...sum, failed: Math.max(sum.failed, 1) };
    process.exitCode = 1;
  }
  const minutes = (performance.now() - begun) / 60_000;
  console.log(`${inWords(sum)}, in ${minutes.toFixed(1)} minutes`);
});
