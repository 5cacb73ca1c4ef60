// Runs a test program compiled to wasm in the browser of the page tests. Cargo calls it with the
// program. wasm-bindgen's own runner needs a WebDriver of exactly the browser's version, one more
// program that a machine may lack, and takes minutes to compile.

import { chromium } from '@playwright/test';
import { copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { bindgen } from './bindgen.mjs';
import { browserFlags, findBrowser } from './browser.mjs';
import { at } from './project.mjs';
import { main } from './run.mjs';
import { serve } from './serve.mjs';

/** The longest time of one test, in milliseconds: software rendering on a busy host is slow. */
const limit = 2 * 60_000;
/**
 * Software rendering can crash a browser, or hang in it, independently of the tests, which are then
 * repeated.
 */
const attempts = 3;

/** The section in which `wasm_bindgen_test_configure` says where tests run, and its words. */
const SECTION = '__wasm_bindgen_test_unstable';
const IN_WORKER = 2;

const PAGE = `<!doctype html><meta charset="utf-8" /><link rel="icon" href="data:," />
<pre id="output"></pre><script type="module" src="./run.js"></script>`;

/** Writes everything that the browser loads for a test program; returns the number of tests. */
async function prepare(program, folder, filters) {
  const module = new WebAssembly.Module(readFileSync(program));
  const exports = WebAssembly.Module.exports(module)
    .map(({ name }) => name)
    .filter((name) => name.startsWith('__wbgt_'))
    .filter((name) => filters.every((filter) => name.includes(filter)));
  const [section] = WebAssembly.Module.customSections(module, SECTION);
  const worker = section !== undefined && new Uint8Array(section).includes(IN_WORKER);
  await bindgen(program, folder, { test: true });
  writeFileSync(join(folder, 'tests.json'), JSON.stringify({ exports, worker }));
  writeFileSync(join(folder, 'index.html'), PAGE);
  copyFileSync(at('.scripts', 'wasm-test-page.mjs'), join(folder, 'run.js'));
  return exports.length;
}

/**
 * Loads the tests, waits for their end, and prints their output. Resolves with whether they passed;
 * null if the browser crashed or hung.
 */
async function runTests(address) {
  const browser = await chromium.launch({
    executablePath: await findBrowser(),
    args: browserFlags,
  });
  try {
    const page = await browser.newPage();
    const messages = [];
    const begun = performance.now();
    const note = (text) =>
      messages.push(`${((performance.now() - begun) / 1000).toFixed(1)} s: ${text}`);
    page.on('pageerror', (error) => note(`error: ${error.stack}`));
    const stopped = new Promise((done) => {
      const hung = setTimeout(() => done(false), limit);
      page.on('console', (message) => {
        note(`${message.type()}: ${message.text()}`);
        hung.refresh();
      });
      page.on('crash', () => done(false));
      page.on('close', () => clearTimeout(hung));
    });
    await page.goto(address);
    const output = page.locator('#output');
    const whole = output.filter({ hasText: 'test result: ' });
    const came = whole.waitFor({ state: 'attached', timeout: 0 }).then(
      () => true,
      () => false,
    );
    const ended = await Promise.race([came, stopped]);
    // A page that crashed has no text.
    const text = await output.textContent({ timeout: 5000 }).catch(() => '');
    const ok = ended && text.includes('test result: ok');
    if (!ended) console.log('The tests did not finish.');
    if (!ok) console.log(`Console of the browser:\n${messages.join('\n')}\n`);
    console.log(text);
    return ended ? ok : null;
  } finally {
    await browser.close();
  }
}

await main(async () => {
  const [program, ...words] = process.argv.slice(2);
  const folder = mkdtempSync(join(tmpdir(), 'wasm-tests-'));
  const filters = words.filter((word) => !word.startsWith('-'));
  let server;
  try {
    if ((await prepare(program, folder, filters)) === 0) return;
    server = await serve(folder, { port: 4400 });
    let passed = null;
    for (let k = 0; passed === null && k < attempts; k++) passed = await runTests(server.address);
    if (!passed) process.exitCode = 1;
  } finally {
    server?.close();
    rmSync(folder, { recursive: true });
  }
});
