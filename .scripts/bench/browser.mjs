// Measures problems in headless Chromium, with the solver module as shipped.

import { findBrowser, browserFlags } from '../browser.mjs';
import { at } from '../project.mjs';
import { host } from './host.mjs';

/** The folder of the module that has the solver. */
const moduleFolder = at('www', 'pkg', 'solver');

/** In the page: passes a task to a new worker and returns its result. */
function performInWorker(task) {
  return new Promise((done, reject) => {
    const worker = new Worker('/bench/worker.mjs', { type: 'module' });
    worker.onerror = (event) => reject(new Error(event.message));
    worker.onmessage = ({ data: { ready, result, error } }) => {
      if (ready) return worker.postMessage(task);
      worker.terminate();
      if (error) reject(new Error(error));
      else done(result);
    };
  });
}

/** Starts the browser; returns { version, perform, close }. */
export async function startBrowser() {
  const { chromium } = await import('@playwright/test');
  const server = await host({
    folders: { '/module/': moduleFolder, '/bench/': at('.scripts', 'bench') },
    // In an isolated page the clock steps by 5 microseconds instead of 100.
    headers: {
      'cross-origin-opener-policy': 'same-origin',
      'cross-origin-embedder-policy': 'require-corp',
    },
  });
  const executablePath = (await findBrowser()) ?? undefined;
  const browser = await chromium.launch({ executablePath, args: browserFlags });
  const page = await browser.newPage();
  await page.goto(`${server.address}bench/page.html`);
  return {
    version: browser.version(),
    /** Returns the result of the task in `worker.mjs`. */
    perform: (measure, task) => page.evaluate(performInWorker, { measure, ...task }),
    async close() {
      await browser.close();
      server.close();
    },
  };
}
