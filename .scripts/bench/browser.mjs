// Measures problems in headless Chromium, with the solver module as shipped.

import { browserFlags, findBrowser } from '../browser.mjs';
import { root } from '../project.mjs';
import { serve } from '../serve.mjs';

/** In the page: performs a measurement of `measures.mjs`. */
const perform = async ([measure, problem, trial]) =>
  (await import('/.scripts/bench/measures.mjs'))[measure](problem, trial);

/** Starts the browser; returns { version, perform, close }. */
export async function startBrowser(trial) {
  const { chromium } = await import('@playwright/test');
  // In an isolated page the clock steps by 5 microseconds instead of 100.
  const extra = {
    'cross-origin-opener-policy': 'same-origin',
    'cross-origin-embedder-policy': 'require-corp',
    // So that compiled code is kept, as it is for later visits of the site.
    'cache-control': 'max-age=600',
  };
  const server = await serve(root, { port: 0, extra });
  const executablePath = (await findBrowser()) ?? undefined;
  const browser = await chromium.launch({ executablePath, args: browserFlags });
  // It stays open: without a page, the browser would end during measurements elsewhere.
  const page = await browser.newPage();
  return {
    version: `Chromium ${browser.version()}`,
    async perform(measure, problem) {
      // Each time with a module that has run nothing yet.
      await page.goto(`${server.address}.scripts/bench/page.html`);
      // Long lists would take a while to get there, and are in the text of the mesh.
      const sent = { ...problem, points: null, faces: null };
      return page.evaluate(perform, [measure, sent, trial]);
    },
    async close() {
      await browser.close();
      server.close();
    },
  };
}
