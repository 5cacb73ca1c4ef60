// Shared by the page tests: a `test` that fails on any complaint of the browser, and the scripting
// interface of the page, `window.shapeUp`.

import {
  test as base,
  expect,
  type Browser,
  type BrowserContext,
  type BrowserContextOptions,
  type ConsoleMessage,
  type Locator,
  type Page,
} from '@playwright/test';
import type { ScriptApi } from '../../www/app/script-api.ts';
import { decodePng, distinctColours, type Picture } from './picture.ts';
import {
  closeContext,
  isAtStart,
  isWaiting,
  lend,
  START,
  type SharedPages,
} from './shared-pages.ts';

export { expect };
export { LONG } from './nightly.ts';

/** Allowed console messages, with the reason. */
const allowed = [
  // wgpu, if WebGPU has no adapter; it then uses WebGL2.
  /No available adapters\./,
  // Service workers are blocked except in the tests about them.
  /Service Worker registration blocked by Playwright/,
  // Chromium, while a screenshot reads the canvas back.
  /GPU stall due to ReadPixels/,
];

declare global {
  interface Window {
    /** How many look at the picture now. */
    lookers?: number;
  }
}

/** Runs in the page: the view does all of its own work, but fills pixels only while a test looks. */
function leaveOutPixels() {
  const prototype: Record<string, (...given: unknown[]) => void> =
    WebGL2RenderingContext.prototype as never;
  for (const name of [
    ...['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced'],
    ...['blitFramebuffer', 'clear', 'clearBufferfv', 'clearBufferfi'],
  ]) {
    const fill = prototype[name];
    prototype[name] = function (...given) {
      if (window.lookers) fill.apply(this, given);
    };
  }
}

/** Runs in the page: it starts with all steps and levels open, as if the user had opened them. */
function openEverything() {
  // A blank page has no storage.
  if (self !== top || location.protocol !== 'http:' || location.search.includes('embed')) return;
  const steps = ['open', 'shape', 'move', 'check', 'build'].map((id) => `step-${id}`);
  const levels = ['mesh', 'weights', 'show', 'plots', 'teach'].map((id) => `level-${id}`);
  localStorage.setItem('shape-up.open', JSON.stringify([...steps, ...levels]));
}

/**
 * The tag of a test that examines the picture, through `seen` or what uses it: that its window has a
 * quarter of the pixels, as if zoomed out to 50 %. Filling them in software takes longer than the
 * rest of a page, so they are filled only while the test looks.
 */
export const looks = { tag: '@looks' };

/** Whether the current test has looked at the picture. */
let hasLooked = false;

/** Device pixels per CSS pixel. */
const HALF = 0.5;

/** A context as Playwright makes it, in which pages start as the options of the test say. */
async function makeContext(browser: Browser, options: BrowserContextOptions, opened = false) {
  const context = await browser.newContext(options);
  await context.addInitScript(leaveOutPixels);
  if (opened) await context.addInitScript(openEverything);
  return context;
}

/** What a test may ask for, and what it gets. */
interface Asked {
  opened: boolean;
  fresh: boolean;
  sameDocument: boolean;
  otherPage: () => Promise<Page>;
  complaints: string[];
}

/**
 * Fails a test if the page throws or the console has an error or a warning. `opened`: whether the
 * page starts with all steps and their second levels open; `fresh`: whether the test gets a browser context of its own,
 * with nothing in its cache, as those need that are about starting, storage or crashes;
 * `sameDocument`: whether it may begin in the document of another test, where `openPage` comes first
 * and nothing in the page is replaced.
 */
export const test = base.extend<Asked, { sharedPages: SharedPages }>({
  opened: [true, { option: true }],
  fresh: [false, { option: true }],
  sameDocument: [false, { option: true }],
  deviceScaleFactor: async ({ deviceScaleFactor }, use, { tags }) =>
    use(tags.includes(looks.tag) ? HALF : deviceScaleFactor),
  sharedPages: [
    // eslint-disable-next-line no-empty-pattern
    async ({}, use) => {
      const pages: SharedPages = new Map();
      await use(pages);
      for (const { context } of pages.values()) await closeContext(context);
      const inVain = [...pages.values()].some(({ startsOverInVain }) => startsOverInVain);
      expect(inVain, 'pages hardly ever start over: see same-document.ts').toBe(false);
    },
    { scope: 'worker' },
  ],
  context: async (
    {
      browser,
      sharedPages,
      fresh,
      sameDocument,
      opened,
      baseURL,
      viewport,
      deviceScaleFactor,
      hasTouch,
      isMobile,
      serviceWorkers,
      permissions,
      proxy,
      contextOptions: { reducedMotion = 'no-preference' },
    },
    use,
    testInfo,
  ) => {
    const options = {
      ...{ baseURL, deviceScaleFactor, hasTouch, isMobile },
      ...{ serviceWorkers, permissions, proxy, reducedMotion },
    };
    const make = () => makeContext(browser, { ...options, viewport }, opened);
    if (fresh) {
      const context = await make();
      await use(context);
      await closeContext(context);
      return;
    }
    const kind = JSON.stringify([options, opened]);
    const asked = { viewport, sameDocument, reducedMotion };
    await lend(sharedPages, kind, make, asked, async (context) => {
      await use(context);
      return testInfo.status === testInfo.expectedStatus;
    });
  },
  /** Makes a page of another user, in a context of its own. */
  otherPage: async ({ browser, baseURL }, use) => {
    const made: BrowserContext[] = [];
    await use(async () => {
      const context = await makeContext(browser, { baseURL, serviceWorkers: 'block' });
      made.push(context);
      return context.newPage();
    });
    for (const context of made) await closeContext(context);
  },
  page: async ({ context }, use) => use(context.pages()[0] ?? (await context.newPage())),
  complaints: [
    async ({ page }, use, { tags }) => {
      hasLooked = false;
      const complaints: string[] = [];
      const heard = {
        pageerror: (error: Error) => complaints.push(`uncaught: ${error.stack ?? error}`),
        console(message: ConsoleMessage) {
          if (!['error', 'warning'].includes(message.type())) return;
          if (allowed.some((pattern) => pattern.test(message.text()))) return;
          // Asked for by the document in which pages wait; told at times only to the next test.
          if (message.location().url.endsWith('/favicon.ico')) return;
          complaints.push(`console ${message.type()}: ${message.text()} ${message.location().url}`);
        },
      };
      page.on('pageerror', heard.pageerror).on('console', heard.console);
      await use(complaints);
      page.off('pageerror', heard.pageerror).off('console', heard.console);
      expect(complaints, 'complaints of the browser').toEqual([]);
      // Otherwise its window has the pixels of another kind of test, or it takes time for nothing.
      const isTagged = tags.includes(looks.tag);
      expect(isTagged, 'a test has the tag `looks` if it looks at the picture').toBe(hasLooked);
    },
    { auto: true },
  ],
});

const meshIsThere = (page: Page) =>
  page.waitForFunction(() => window.shapeUp?.state().vertices > 0);

/**
 * Opens the page itself, which starts with the saved work or else the first example, solved.
 * `query`: that of the address, without "?".
 */
export async function visit(page: Page, query = '') {
  await page.goto(query ? `./?${query}` : './');
  await meshIsThere(page);
}

/** Opens the first example by its link, at its start and unsolved. */
export async function openPage(page: Page, query = '') {
  if (await isAtStart(page, query)) return;
  // If the page is already open, changing the fragment would not reload it.
  if (page.url() !== 'about:blank' && !isWaiting(page)) await page.goto('about:blank');
  await page.goto(START.replace('?', `?${query}`));
  await meshIsThere(page);
}

/** Holds the answers of an address back; returns a function that lets them go. */
export async function hold(page: Page, address: string) {
  let release!: () => void;
  const released = new Promise<void>((done) => (release = done));
  await page.route(address, async (route) => {
    const response = await route.fetch();
    await released;
    await route.fulfill({ response });
  });
  return release;
}

/** Waits until the built files are cached and the service worker serves them. */
export async function keptOffline(page: Page) {
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
}

/** What `window.shapeUp.state()` returns. */
export type PageState = ReturnType<ScriptApi['state']>;

/** `window.shapeUp.state()`. */
export const state = (page: Page) => page.evaluate(() => window.shapeUp.state());

/**
 * Waits until `condition(state, argument)` holds and returns the state. The condition runs in the
 * page, so it can use only its arguments.
 */
export async function waitForState<Given>(
  page: Page,
  condition: (now: PageState, given: Given) => unknown,
  argument?: Given,
  options?: { timeout?: number },
) {
  // `shapeUp` does not exist while another page is loading.
  const body = `const now = window.shapeUp?.state(); return now ? (${condition})(now, given) : false;`;
  const inPage = new Function('given', body) as (given: Given) => unknown;
  await page.waitForFunction(inPage as (given: unknown) => unknown, argument, options);
  return state(page);
}

/** The scene after the last edit or the end of the last run. */
export const sceneOf = (page: Page) => page.evaluate(() => window.shapeUp.scene());

/** The whole document and the exact shape. */
export const everything = (page: Page) =>
  page.evaluate(() => ({
    scene: window.shapeUp.scene(),
    positions: [...window.shapeUp.positions()],
    iteration: window.shapeUp.state().iteration,
  }));

/** The position of a vertex, in file coordinates. */
export const positionOf = (page: Page, vertex: number) =>
  page.evaluate((v) => [...window.shapeUp.positions().slice(3 * v, 3 * v + 3)], vertex);

/**
 * The position of a vertex on the page, [x, y] in CSS pixels. Waits for the view; fails if the
 * vertex is hidden.
 */
export async function screenOf(page: Page, vertex: number): Promise<[number, number]> {
  let point: [number, number] | null = null;
  const look = async () => (point = await page.evaluate((v) => window.shapeUp.screen(v), vertex));
  await expect.poll(look, { message: `vertex ${vertex} is on the screen` }).not.toBeNull();
  return point ?? [NaN, NaN];
}

/** The middle of some vertices on the page, [x, y] in CSS pixels. */
export async function middleOf(page: Page, vertices: number[]): Promise<[number, number]> {
  const at = await Promise.all(vertices.map((one) => screenOf(page, one)));
  const mean = (axis: number) => at.reduce((sum, point) => sum + point[axis], 0) / at.length;
  return [mean(0), mean(1)];
}

/** Drags a vertex by [dx, dy] CSS pixels with the mouse, in a few moves. */
export async function dragVertex(page: Page, vertex: number, [dx, dy]: number[]) {
  const [x, y] = await screenOf(page, vertex);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx, y + dy, { steps: 5 });
  await page.mouse.up();
}

/** The size of the window in CSS pixels. */
export function windowOf(page: Page) {
  const size = page.viewportSize();
  if (!size) throw new Error('the window has no size of its own');
  return size;
}

/** Where an element is on the page, in CSS pixels; fails if it is not shown. */
export async function boxOf(element: Locator) {
  const box = await element.boundingBox();
  if (!box) throw new Error(`not on the page: ${element}`);
  return box;
}

/** A value that may be missing by its type, but is there; fails if it is not. */
export function known<Value>(value: Value | null | undefined): Value {
  if (value === null || value === undefined) throw new Error('a value is missing');
  return value;
}

/**
 * Waits until the solver has answered all that it was asked: only then is it certain that a press
 * changed nothing.
 */
export const settled = (page: Page) => page.evaluate(() => window.shapeUp.settled());

/** Waits until the picture is up to date. */
export const drawn = (page: Page) => page.evaluate(() => window.shapeUp.drawn());

/** Lets the pages that are opened from now on fill pixels from their start. */
export async function seeFromTheStart(page: Page) {
  hasLooked = true;
  await page.addInitScript(() => (window.lookers = 1));
}

/** Runs in the page: begins to fill pixels, with a picture that is all drawn anew. */
async function beginToLook() {
  const { shapeUp } = window;
  const camera = shapeUp?.camera();
  // Occlusion is kept while the camera stays: it was found without pixels.
  if (camera) shapeUp.look(camera.with(0, camera[0] + 0.001));
  await shapeUp?.drawn();
  window.lookers = (window.lookers ?? 0) + 1;
  if (camera) shapeUp.look(camera);
  await shapeUp?.drawn();
}

/** Looks at the picture, which is up to date: pixels are filled as long as `look` runs. */
export async function seen<Found>(page: Page, look: () => Promise<Found>) {
  hasLooked = true;
  await page.evaluate(beginToLook);
  const found = await look();
  await page.evaluate(() => (window.lookers = (window.lookers ?? 1) - 1));
  return found;
}

const viewOf = (page: Page) => page.getByRole('application', { name: '3D view' });

/** A part of the page as pixels, by default the 3D view with what lies over it. */
export const pictureOf = (page: Page, part: Locator = viewOf(page)): Promise<Picture> =>
  seen(page, async () => decodePng(await part.screenshot()));

/** The middle of the picture, which nothing covers, as pixels. */
export async function middleOfPicture(page: Page) {
  const { x, y, width, height } = await boxOf(viewOf(page));
  const clip = { x: x + width / 4, y: y + height / 4, width: width / 2, height: height / 2 };
  return seen(page, async () => decodePng(await page.screenshot({ clip })));
}

/** The number of different colours in the 3D view; a blank one has one. */
export const coloursOfView = async (page: Page) => distinctColours(await pictureOf(page));
