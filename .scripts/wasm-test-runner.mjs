// Runs a test program compiled to wasm in the browser of the page tests. Cargo calls it with the
// program. wasm-bindgen's own runner serves the tests; it could also drive the browser, but only
// through a WebDriver of exactly the same version, one more program that a machine may lack.

import { spawn } from 'node:child_process';
import { chromium } from '@playwright/test';
import { browserFlags, findBrowser } from './browser.mjs';
import { root } from './project.mjs';
import { main, Problem } from './run.mjs';
import { testRunner } from './setup-bindgen.mjs';

/** The longest time of one test, in milliseconds: software rendering on a busy host is slow. */
const limit = 2 * 60_000;
/**
 * Software rendering can crash a browser, or hang in it, independently of the tests, which are then
 * repeated.
 */
const attempts = 3;

/** Starts the server and resolves with its address; null if there is no test to serve. */
function addressOf(server) {
  return new Promise((done, reject) => {
    let output = '';
    const read = (chunk) => {
      output += chunk;
      const address = output.match(/now available at (http:\S+)/);
      if (address) done(address[1]);
    };
    server.stdout.setEncoding('utf8').on('data', read);
    server.stderr.setEncoding('utf8').on('data', read);
    server.on('error', reject);
    server.on('close', (code) => {
      if (code === 0) done(null);
      else reject(new Problem(`${output}\nwasm-bindgen-test-runner ended with ${code}`));
    });
  });
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
  const server = spawn(testRunner, process.argv.slice(2), {
    cwd: root,
    env: { ...process.env, NO_HEADLESS: '1', WASM_BINDGEN_TEST_ADDRESS: '127.0.0.1:0' },
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  try {
    const address = await addressOf(server);
    let passed = null;
    for (let k = 0; address && passed === null && k < attempts; k++) {
      passed = await runTests(address);
    }
    if (address && !passed) process.exitCode = 1;
  } finally {
    server.kill();
  }
});
