// How many tests passed and failed, were skipped, and passed only when they were run again, read from what
// the test programs print; and which of these are excused.

/** What counts as what in the output of each kind of test program, with how often, or with a name. */
const PRINTED = {
  // Cargo and wasm-bindgen's runner, one line a test program.
  cargo: {
    passed: /test result: \w+\. (\d+) passed/g,
    failed: /test result: \w+\. \d+ passed; (\d+) failed/g,
    skippedTests: /^test (.*) \.\.\. ignored/gm,
  },
  // Node's test runner, in its TAP form.
  node: {
    passed: /^# pass (\d+)$/gm,
    failed: /^# fail (\d+)$/gm,
    skippedTests: /^\s*ok \d+ - (.*?) # (?:SKIP|TODO)/gm,
  },
  // Playwright's list; a test that did not run has not passed, and one that is flaky has in the end.
  playwright: {
    passed: /^ +(\d+) (?:passed|flaky)/gm,
    failed: /^ +(\d+) (?:failed|interrupted|did not run)/gm,
    skippedTests: /^ +- +\d+ (.*)$/gm,
    flakyTests: /^ +\d+ flaky\n((?: {4}.*\n?)+)/gm,
  },
};

/**
 * Tests that may be skipped, or may need a second run, each with a part of its name and the reason.
 * @type {{ name: string, reason: string }[]}
 */
export const EXCUSED = [];

/**
 * Adds up the counts in `output`, as `kind` of test program prints them; with the names of the tests that
 * were skipped or flaky.
 */
export function countTests(kind, output) {
  const printed = PRINTED[kind];
  const found = (pattern) => (pattern ? [...output.matchAll(pattern)].map(([, one]) => one) : []);
  const sum = (pattern) => found(pattern).reduce((total, count) => total + Number(count), 0);
  const lines = (pattern) => found(pattern).flatMap((text) => text.trim().split(/\s*\n\s*/));
  return {
    passed: sum(printed.passed),
    failed: sum(printed.failed),
    skipped: lines(printed.skippedTests),
    flaky: lines(printed.flakyTests),
  };
}

/** Those of these tests that nothing excuses. */
export const inexcusable = (tests, excused = EXCUSED) =>
  tests.filter((test) => !excused.some(({ name }) => test.includes(name)));
