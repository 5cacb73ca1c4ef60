// Runs a test program that was compiled to wasm, in the browser of the page tests. Cargo calls it
// with the program. wasm-bindgen's own runner serves the tests; left to itself it would also drive
// the browser, but only through a WebDriver of the very same version, which is one more program
// that a machine may lack.

import { spawn } from 'node:child_process';
import { chromium } from '@playwright/test';
import { browserFlags, findBrowser } from './browser.mjs';
import { root } from './project.mjs';
import { main, Problem } from './run.mjs';
import { testRunner } from './setup-bindgen.mjs';

const limit = 10 * 60_000;

/** Starts the server and resolves with its address, or with null when there is no test to serve. */
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

/** Loads the tests, waits for their end, and returns what they printed. */
async function runTests(address) {
  const browser = await chromium.launch({
    executablePath: await findBrowser(),
    args: browserFlags,
  });
  try {
    const page = await browser.newPage();
    const messages = [];
    page.on('console', (message) => messages.push(`${message.type()}: ${message.text()}`));
    page.on('pageerror', (error) => messages.push(`error: ${error.stack}`));
    await page.goto(address);
    const output = page.locator('#output');
    const ended = await output
      .filter({ hasText: 'test result: ' })
      .waitFor({ state: 'attached', timeout: limit })
      .then(
        () => true,
        () => false,
      );
    const text = await output.textContent();
    const ok = ended && text.includes('test result: ok');
    if (!ended) console.log('The tests did not come to an end.');
    if (!ok) console.log(`Console of the browser:\n${messages.join('\n')}\n`);
    console.log(text);
    return ok;
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
    if (address && !(await runTests(address))) process.exitCode = 1;
  } finally {
    server.kill();
  }
});
