// Pages that tests share: a new page takes twice the processor time of one that loads the site
// again, whose files and compiled code the browser has kept. Between two tests everything that the
// first did is undone, and the document is left, so that the next test begins with a new one. A test
// that does more than is undone here (listens to the page, replaces its clock, exposes a function)
// asks for a page of its own: `test.use({ fresh: true })`.

import { startOf, startOver, type Start } from './same-document.ts';
import type { BrowserContext, Page, ViewportSize } from '@playwright/test';

/** The address of the first example, at its start and unsolved. */
export const START = './?#example=canopy';

/** A document of the site without scripts, in which a page waits for the next test. */
const WAITING = 'icon.svg';

/** Whether a page is there. */
export const isWaiting = (page: Page) => page.url().endsWith(`/${WAITING}`);

/** The media that every test begins with, beside the motion of its project. */
const MEDIA = { media: null, colorScheme: 'light', forcedColors: 'none' } as const;

/** Runs in the page: deletes all that the site has stored. */
async function forget() {
  localStorage.clear();
  sessionStorage.clear();
  for (const { name = '' } of await indexedDB.databases()) {
    await new Promise<void>((done, reject) => {
      const deleted = indexedDB.deleteDatabase(name);
      deleted.onsuccess = () => done();
      deleted.onerror = () => reject(deleted.error ?? new Error('not deleted'));
    });
  }
}

/**
 * Closes a context, its pages first: of pages that are open Playwright takes pictures, in case the
 * test has failed, although it has taken them before.
 */
export async function closeContext(context: BrowserContext) {
  for (const page of context.pages()) await page.close();
  await context.close();
}

/**
 * The size of the windows whose pages show the first example, as if it had just been opened by its
 * link.
 */
const atStart: WeakMap<Page, string> = new WeakMap();

const sizeOf = (page: Page) => JSON.stringify(page.viewportSize());

/**
 * Whether a page shows the first example like that, in a window that still has its size. If not, it
 * is left, so that it can be opened.
 * @param query what is asked of the page by its address
 */
export async function isAtStart(page: Page, query: string) {
  const size = atStart.get(page);
  if (size === undefined) return false;
  atStart.delete(page);
  if (query === '' && size === sizeOf(page)) return true;
  await leave(page);
  return false;
}

/** Leaves the document of a page, and deletes all that the site has stored. */
export async function leave(page: Page) {
  atStart.delete(page);
  await page.goto(WAITING);
  await page.evaluate(forget);
}

/** Number of tries that say something. */
const ENOUGH = 10;

/** A page in a context of its own. */
class SharedPage {
  #context;
  #page;
  #start: Start | null = null;
  /** How often it was to start over in the same document, and how often it did. */
  #tries = 0;
  #successes = 0;
  #size;
  /** The scripts that a test has added. */
  #scripts: { dispose(): Promise<void> }[] = [];

  constructor(context: BrowserContext, page: Page) {
    this.#context = context;
    this.#page = page;
    this.#size = page.viewportSize();
    const add = page.addInitScript.bind(page);
    page.addInitScript = async (...given) => {
      // It runs in new documents only.
      if (atStart.has(page)) await leave(page);
      const script = await add(...given);
      this.#scripts.push(script);
      return script;
    };
  }

  get context() {
    return this.#context;
  }

  /**
   * Whether it nearly always took a new document although it was to start over in the same: then
   * something of the page is not undone, and all tests take twice the time without another sign.
   */
  get startsOverInVain() {
    return this.#tries >= ENOUGH && this.#successes < this.#tries / 2;
  }

  /** Prepares the page for a test. */
  async begin({ viewport, sameDocument }: Use) {
    if (viewport) await this.#page.setViewportSize(viewport);
    const isAsLeft = sameDocument && atStart.get(this.#page) === sizeOf(this.#page);
    if (atStart.has(this.#page) && !isAsLeft) await leave(this.#page);
  }

  /** Undoes what a test has done. Rejects if the page cannot be used again. */
  async reset({ sameDocument, reducedMotion }: Use) {
    const [context, page] = [this.#context, this.#page];
    for (const other of context.pages()) if (other !== page) await other.close();
    const isAsMade = this.#scripts.length === 0;
    for (const script of this.#scripts.splice(0)) await script.dispose();
    await page.unrouteAll({ behavior: 'ignoreErrors' });
    await context.setOffline(false);
    await context.clearPermissions();
    await page.emulateMedia({ ...MEDIA, reducedMotion });
    if (this.#size) await page.setViewportSize(this.#size);
    // Away from the view, then outside the page, as before the first movement.
    for (const at of [1, -1]) await page.mouse.move(at, at);
    if (!sameDocument) return leave(page);
    const isBack =
      isAsMade && this.#start && (await startOver(page, this.#start).catch(() => false));
    if (this.#start && isAsMade) this.#tries += 1;
    if (isBack) this.#successes += 1;
    else {
      await leave(page);
      if (this.#start) return;
      await page.goto(START);
      this.#start = await startOf(page);
    }
    atStart.set(page, sizeOf(page));
  }
}

/** The shared pages of a worker process, by what they differ in. */
export type SharedPages = Map<string, SharedPage>;

interface Use {
  viewport: ViewportSize | null;
  /** whether the test begins with `openPage`, and can do so in the document of another test */
  sameDocument: boolean;
  reducedMotion: 'reduce' | 'no-preference' | null;
}

/**
 * Lends a shared page to a test, `run`, which returns whether it has passed. The page of a test that
 * failed is not used again.
 * @param kind tests that give the same one share a page, whatever the size of its window
 */
export async function lend(
  pages: SharedPages,
  kind: string,
  make: () => Promise<BrowserContext>,
  use: Use,
  run: (context: BrowserContext) => Promise<boolean>,
) {
  if (!pages.has(kind)) {
    const context = await make();
    pages.set(kind, new SharedPage(context, await context.newPage()));
  }
  const shared = pages.get(kind) as SharedPage;
  await shared.begin(use);
  const hasPassed = await run(shared.context);
  const isReady =
    hasPassed &&
    (await shared.reset(use).then(
      () => true,
      () => false,
    ));
  if (isReady) return;
  pages.delete(kind);
  await closeContext(shared.context);
}
