// Measures problems in headless Chromium, with the solver module as shipped.

import { browserFlags, findBrowser } from '../browser.mjs';
import { at } from '../project.mjs';
import { host } from './host.mjs';

/** The folder of the module that has the solver. */
const moduleFolder = at('www', 'pkg', 'engine');

/** In the page: performs a task of `measures.mjs`. */
const perform = async ([measure, task]) => (await import('/bench/measures.mjs'))[measure](task);

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
  // It stays open: without a page, the browser would end during measurements elsewhere.
  const page = await browser.newPage();
  return {
    version: browser.version(),
    async perform(measure, task) {
      // Each time with a module that has run nothing yet.
      await page.goto(`${server.address}bench/page.html`);
      return page.evaluate(perform, [measure, task]);
    },
    async close() {
      await browser.close();
      server.close();
    },
  };
}
