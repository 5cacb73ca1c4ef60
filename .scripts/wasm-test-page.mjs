// Runs the tests of a module in the page, or in a worker if they ask for one, as wasm-bindgen's own
// test runner does; the runner that serves this file is wasm-test-runner.mjs.

const inWorker = typeof document === 'undefined';
const { exports, worker } = await (await fetch('./tests.json')).json();

if (worker && !inWorker) {
  const output = document.getElementById('output');
  const runner = new Worker('./run.js', { type: 'module' });
  runner.onmessage = ({ data }) => (output.textContent += `${data}\n`);
  runner.onerror = ({ message }) => console.error(`The worker of the tests: ${message}`);
} else {
  const tests = await import('./tests.js');
  // The output of a test is captured, and printed if it fails.
  for (const method of ['debug', 'log', 'info', 'warn', 'error']) {
    const print = console[method];
    console[method] = (...words) => {
      print.apply(console, words);
      tests[`__wbgtest_console_${method}`](words);
    };
  }
  self.__wbg_test_invoke = (test) => test();
  self.__wbg_test_output_writeln = (...words) => postMessage(words.join(' '));
  const module = await tests.default('./tests_bg.wasm');
  const context = new tests.WasmBindgenTestContext(false);
  context.include_ignored(false);
  context.filtered_count(0);
  await context.run(exports.map((name) => module[name]));
}
