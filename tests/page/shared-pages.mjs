// Pages that tests share: a new page takes twice the processor time of one that loads the site
// again, whose files and compiled code the browser has kept. Between two tests everything that the
// first did is undone, and the document is left, so that the next test begins with a new one. A test
// that does more than is undone here (listens to the page, replaces its clock, exposes a function)
// asks for a page of its own: `test.use({ fresh: true })`.

/** A document of the site without scripts, in which a page waits for the next test. */
const WAITING = 'icon.svg';

/** Whether a page is there. */
export const isWaiting = (page) => page.url().endsWith(`/${WAITING}`);

/** The media that every test begins with. */
const MEDIA = /** @type {const} */ ({
  ...{ media: null, colorScheme: 'light', reducedMotion: 'no-preference', forcedColors: 'none' },
});

/** Runs in the page: deletes all that the site has stored. */
async function forget() {
  localStorage.clear();
  sessionStorage.clear();
  for (const { name } of await indexedDB.databases()) {
    await new Promise((done, reject) => {
      const deleted = indexedDB.deleteDatabase(name);
      deleted.onsuccess = done;
      deleted.onerror = () => reject(deleted.error);
    });
  }
}

/**
 * Closes a context, its pages first: of pages that are open Playwright takes pictures, in case the
 * test has failed, although it has taken them before.
 * @param {import("@playwright/test").BrowserContext} context
 */
export async function closeContext(context) {
  for (const page of context.pages()) await page.close();
  await context.close();
}

/** A page in a context of its own. */
export class SharedPage {
  #context;
  #page;
  #viewport;
  /** The scripts that a test has added. @type {{ dispose(): Promise<void> }[]} */
  #scripts = [];

  /**
   * @param {import("@playwright/test").BrowserContext} context
   * @param {import("@playwright/test").Page} page
   */
  constructor(context, page) {
    this.#context = context;
    this.#page = page;
    this.#viewport = page.viewportSize();
    const add = page.addInitScript.bind(page);
    page.addInitScript = async (...given) => {
      const script = await add(...given);
      this.#scripts.push(script);
      return script;
    };
  }

  get context() {
    return this.#context;
  }

  /** Undoes what a test has done. Rejects if the page cannot be used again. */
  async reset() {
    const [context, page] = [this.#context, this.#page];
    for (const other of context.pages()) if (other !== page) await other.close();
    for (const script of this.#scripts.splice(0)) await script.dispose();
    await page.unrouteAll({ behavior: 'ignoreErrors' });
    await context.setOffline(false);
    await context.clearPermissions();
    await page.emulateMedia(MEDIA);
    await page.setViewportSize(this.#viewport);
    // Outside the page, as before the first movement.
    await page.mouse.move(-1, -1);
    await page.goto(WAITING);
    await page.evaluate(forget);
  }
}

/**
 * The shared pages of a worker process, by what they differ in.
 * @typedef {Map<string, SharedPage>} SharedPages
 */

/**
 * Lends a shared page to a test, `use`, which returns whether it has passed. The page of a test that
 * failed is not used again.
 * @param {SharedPages} pages
 * @param {string} key
 * @param {() => Promise<import("@playwright/test").BrowserContext>} make
 * @param {(context: import("@playwright/test").BrowserContext) => Promise<boolean>} use
 */
export async function lend(pages, key, make, use) {
  if (!pages.has(key)) {
    const context = await make();
    pages.set(key, new SharedPage(context, await context.newPage()));
  }
  const shared = pages.get(key);
  const hasPassed = await use(shared.context);
  const isReady =
    hasPassed &&
    (await shared.reset().then(
      () => true,
      () => false,
    ));
  if (isReady) return;
  pages.delete(key);
  await closeContext(shared.context);
}
