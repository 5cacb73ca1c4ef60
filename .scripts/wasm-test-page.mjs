// Runs the tests of a module in the page, or in a worker if they ask for one, as wasm-bindgen's own
// test runner does; the runner that serves this file is wasm-test-runner.mjs.

const METHODS = ['debug', 'log', 'info', 'warn', 'error'];

const inWorker = typeof document === 'undefined';
const write = (line) => {
  if (inWorker) postMessage(line);
  else document.getElementById('output').append(`${line}\n`);
};

/** Runs the exported tests of the module beside this file. */
async function runTests(exports) {
  const tests = await import('./tests.js');
  self.__wbg_test_invoke = (test) => test();
  self.__wbg_test_output_writeln = (...words) => write(words.join(' '));
  const module = await tests.default({ module_or_path: './tests_bg.wasm' });
  // The output of a test is captured, and printed if it fails.
  for (const method of METHODS) {
    const print = console[method];
    console[method] = (...words) => {
      print.apply(console, words);
      tests[`__wbgtest_console_${method}`](words);
    };
  }
  const context = new tests.WasmBindgenTestContext(false);
  context.include_ignored(false);
  context.filtered_count(0);
  await context.run(exports.map((name) => module[name]));
}

try {
  const { exports, worker } = await (await fetch('./tests.json')).json();
  if (worker && !inWorker) {
    const runner = new Worker('./run.js', { type: 'module' });
    runner.onmessage = ({ data }) => write(data);
  } else {
    await runTests(exports);
  }
} catch (error) {
  write(`test result: FAILED. The tests could not begin: ${error.stack}`);
}
