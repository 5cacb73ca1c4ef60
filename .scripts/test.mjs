// npm test: all checks, the fast ones first; at the end it prints how many tests passed.
// npm run check: those that need no browser. npm run test:long: with the long versions of tests.

import { existsSync } from 'node:fs';
import { stages } from './checks.mjs';
import { countTests, inexcusable } from './count.mjs';
import { targetFolder } from './project.mjs';
import { main, Problem } from './run.mjs';
import { setUp } from './setup.mjs';
import { step } from './step.mjs';

/** Number of tests that may be flaky without an excuse: shared hosts stall at times. */
const MOST_FLAKY = 2;

const sum = { passed: 0, failed: 0, skipped: 0, flaky: 0 };

const inWords = ({ passed, failed, skipped, flaky }) =>
  `${passed} passed, ${failed} failed, ${skipped} skipped, ${flaky} flaky`;

/** Adds the tests of a step to the sum; returns what is to be said of them. */
function counted(kind, { ok, output }) {
  const { passed, failed, skipped, flaky } = countTests(kind, output);
  const numbers = { passed, failed, skipped: skipped.length, flaky: flaky.length };
  for (const key of Object.keys(sum)) sum[key] += numbers[key];
  const [unrun, unsteady] = [inexcusable(skipped), inexcusable(flaky)];
  if (unrun.length > 0 || unsteady.length > MOST_FLAKY) process.exitCode = 1;
  return [
    `    ${inWords(numbers)}`,
    ...unrun.map((test) => `    skipped without a reason: ${test}`),
    ...unsteady.map((test) => `    flaky without a reason: ${test}`),
    // How they failed at first: Playwright numbers its reports.
    ...(ok && unsteady.length > 0 ? [output.slice(output.search(/^ +1\) /m))] : []),
  ];
}

/** Whether a step has failed: no step begins after that. */
let failed = false;

/** Runs the steps of a lane one after another. */
async function lane(steps) {
  for (const { title, run, env, count, show } of steps) {
    if (failed) return;
    const done = await step(title, ...run, env);
    for (const line of count ? counted(count, done) : []) console.log(line);
    if (show && done.ok) console.log(done.output);
    failed ||= !done.ok;
  }
}

await main(async () => {
  const [command = 'test'] = process.argv.slice(2);
  if (!(command in stages)) throw new Problem(`usage: test.mjs ${Object.keys(stages).join('|')}`);
  if (command === 'long') Object.assign(process.env, { LONG: '1', SHAPE_UP_FUZZ: '20' });
  // In a fresh clone, recording what the next build could reuse would cost a fifth of this one.
  if (!existsSync(targetFolder)) process.env.CARGO_INCREMENTAL ??= '0';
  const begun = performance.now();
  await setUp({ checks: true });
  console.log(`- set-up\n    ok (${((performance.now() - begun) / 1000).toFixed(1)} s)`);
  for (const lanes of stages[command]) await Promise.all(lanes.map(lane));
  if (failed) {
    // A step without tests of its own counts as one failure.
    sum.failed = Math.max(sum.failed, 1);
    process.exitCode = 1;
  }
  const minutes = (performance.now() - begun) / 60_000;
  console.log(`${inWords(sum)}, in ${minutes.toFixed(1)} minutes`);
});
