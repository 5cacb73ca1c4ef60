// How many tests passed and failed, read from what the test programs print.

const patterns = {
  // Cargo and wasm-bindgen's runner, one line a test program.
  cargo: [/test result: \w+\. (\d+) passed; (\d+) failed/g],
  // Node's test runner, in its TAP form.
  node: [/^# pass (\d+)$/gm, /^# fail (\d+)$/gm],
  // Playwright's list; a test that did not run has not passed.
  playwright: [/^ +(\d+) (?:passed|flaky)/gm, /^ +(\d+) (?:failed|interrupted|did not run)/gm],
};

/** Adds up the counts in `output`, as `kind` of test program prints them. */
export function countTests(kind, output) {
  const sum = { passed: 0, failed: 0 };
  const [first, second] = patterns[kind];
  for (const [, passed, failed = 0] of output.matchAll(first)) {
    sum.passed += Number(passed);
    sum.failed += Number(failed);
  }
  for (const [, failed] of second ? output.matchAll(second) : []) sum.failed += Number(failed);
  return sum;
}
