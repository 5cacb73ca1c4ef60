// Counts passed, failed, skipped and flaky tests (passed in a second run) in the output of the test
// programs, and finds those that are not excused.

/** Patterns for the output of each kind of test program; they capture a count or a name. */
const PRINTED = {
  // Cargo and wasm-bindgen's runner, one line per test program.
  cargo: {
    passed: /test result: \w+\. (\d+) passed/g,
    failed: /test result: \w+\. \d+ passed; (\d+) failed/g,
    skippedTests: /^test (.*) \.\.\. ignored/gm,
    // With `--show-output`: tests that passed, and said that there was nothing for them to look at.
    withoutInput: /^---- (.*) stdout ----\n(?:(?!---- ).*\n)*?skipped: (.*)$/gm,
  },
  // Node's test runner, in its TAP format.
  node: {
    passed: /^# pass (\d+)$/gm,
    failed: /^# fail (\d+)$/gm,
    skippedTests: /^\s*ok \d+ - (.*?) # (?:SKIP|TODO)/gm,
  },
  // Playwright's list; a test that did not run counts as failed, a flaky one as passed.
  playwright: {
    passed: /^ +(\d+) (?:passed|flaky)/gm,
    failed: /^ +(\d+) (?:failed|interrupted|did not run)/gm,
    skippedTests: /^ +- +\d+ (.*)$/gm,
    flakyTests: /^ +\d+ flaky\n((?: {4}.*\n?)+)/gm,
  },
};

/**
 * Tests that may be skipped or flaky, each with a part of its name and the reason.
 * @type {{ name: string, reason: string }[]}
 */
export const EXCUSED = [
  {
    name: 'there is no ../shared',
    reason: 'a clone of the repository alone has no other material',
  },
  { name: 'there is no python3', reason: 'only the script for Rhino needs it' },
  // The nightly run has both.
  ...(process.env.CI ? [] : ['Firefox', 'WebKit']).map((browser) => ({
    name: `there is no ${browser}`,
    reason: 'only one story needs it',
  })),
];

/** Adds up the counts in the `output` of a `kind` of test program; names skipped, flaky tests. */
export function countTests(kind, output) {
  const printed = PRINTED[kind];
  const withoutInput = [...output.matchAll(printed.withoutInput ?? /$^/g)].map(
    ([, test, reason]) => `${test}: ${reason}`,
  );
  const found = (pattern) => (pattern ? [...output.matchAll(pattern)].map(([, one]) => one) : []);
  const sum = (pattern) => found(pattern).reduce((total, count) => total + Number(count), 0);
  const lines = (pattern) => found(pattern).flatMap((text) => text.trim().split(/\s*\n\s*/));
  return {
    passed: sum(printed.passed) - withoutInput.length,
    failed: sum(printed.failed),
    skipped: [...lines(printed.skippedTests), ...withoutInput],
    flaky: lines(printed.flakyTests),
  };
}

/** Returns the tests that are not excused. */
export const inexcusable = (tests, excused = EXCUSED) =>
  tests.filter((test) => !excused.some(({ name }) => test.includes(name)));

/** Whether a step that passed is run again although nothing changes: for these tests it did not. */
export const isToRunAgain = ({ skipped, flaky }, excused = EXCUSED) =>
  inexcusable(skipped, excused).length > 0 || flaky.length > 0;
