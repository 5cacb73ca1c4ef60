// Starting over in the same document, which takes a third of the time of loading another. The first
// example is opened once more, and all that can be seen of the page is compared with a new one: if
// anything differs (a setting, an open panel, the camera), the page is not used like that. What the
// page remembers and does not show cannot be compared: which rows were opened, and the last operation
// on a mesh. Tests to which that matters do not say `sameDocument`.

import type { Page } from '@playwright/test';

/** Runs in the page: the ids of the steps and levels that are open. */
const openLevels = () =>
  [...document.querySelectorAll('#steps details[id][open]')].map(({ id }) => id);

/**
 * Runs in the page: closes what is open but for steps and levels, and opens the first example by its
 * link.
 * @param levels ids of the steps and levels that are to be open
 */
async function openAgain(levels: string[]) {
  const { shapeUp } = window;
  document.querySelectorAll<HTMLDialogElement>('dialog[open]').forEach((dialog) => dialog.close());
  document
    .querySelectorAll<HTMLElement>('.docked:not([hidden]) [aria-label^=Close]')
    .forEach((close) => close.click());
  document
    .querySelectorAll<HTMLDetailsElement>('details')
    .forEach((details) => (details.open = levels.includes(details.id)));
  // The toolbars remember the last button that had the focus.
  document.querySelectorAll('[role=toolbar]').forEach((bar) => {
    bar.querySelector<HTMLElement>('input, button')?.focus();
  });
  document.querySelector<HTMLElement>('#analysis [role=tab]')?.click();
  // A model of four vertices, so that the example is seen to arrive.
  await shapeUp.open('v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n', 'square.obj');
  history.replaceState(null, '', `${location.pathname}?`);
  location.hash = 'example=canopy';
  const until = performance.now() + 5000;
  while (shapeUp.state().vertices <= 4 && performance.now() < until)
    await new Promise((done) => setTimeout(done, 5));
  await shapeUp.drawn();
  localStorage.removeItem('shape-up.works');
  getSelection()?.removeAllRanges();
}

/** Runs in the page: all that can be seen of it, as one text. */
async function look() {
  const { shapeUp } = window;
  await shapeUp.drawn();
  const seen = [...document.querySelectorAll('body *')]
    .filter((one) => !one.closest('svg') && one.checkVisibility({ visibilityProperty: true }))
    .map((one) => {
      // An empty style, or an empty note of the page's own, is none.
      const isSaid = ({ name, value }: Attr) => value !== '' || !/^(style|data-.*)$/.test(name);
      const attributes = [...one.attributes].filter(isSaid).map((it) => `${it.name}=${it.value}`);
      const words = [...one.childNodes].filter(({ nodeType }) => nodeType === Node.TEXT_NODE);
      const { localName, value, checked, disabled } = one as HTMLInputElement;
      return [
        localName,
        ...attributes.sort(),
        value,
        checked,
        disabled,
        ...words.map(({ nodeValue }) => nodeValue),
      ];
    });
  const places = [0, 40, 99, 200].map((vertex) => shapeUp.screen(vertex)?.map(Math.round));
  const { documentElement, body, activeElement } = document;
  // Which tab of the steps is chosen matters only where they are tabs.
  const { step, sheet, ...noted } = body.dataset;
  const tab = innerWidth < 700 && [step, sheet];
  return JSON.stringify([
    ...[seen, places, { ...shapeUp.state(), last_step_ms: 0 }, activeElement?.localName],
    ...[{ ...documentElement.dataset }, noted, tab, body.className],
    ...[Object.keys(localStorage).sort(), Object.keys(sessionStorage).sort()],
  ]);
}

/** Largest number of looks at a page, and the time between them in ms, until it is at rest. */
const [LOOKS, EVERY] = [30, 100];

/** A page that has opened the first example. */
export interface Start {
  look: string;
  /** ids of the steps and levels that are open */
  levels: string[];
}

/** The start of a page in a new document. */
export const startOf = async (page: Page): Promise<Start> => ({
  look: await lookOf(page),
  levels: await page.evaluate(openLevels),
});

/** What a page looks like, once it is at rest or as `expected`. */
async function lookOf(page: Page, expected = '') {
  await page.waitForFunction(() => window.shapeUp.state().renderer.startsWith('web'));
  let last = '';
  for (let time = 0; time < LOOKS; time++) {
    const now = await page.evaluate(look);
    if (now === last || now === expected) return now;
    last = now;
    await new Promise((done) => setTimeout(done, EVERY));
  }
  return last;
}

/**
 * Opens the first example again.
 * @param start that in a new document
 * @returns whether the page looks like that
 */
export async function startOver(page: Page, { look: wanted, levels }: Start): Promise<boolean> {
  const isThere = await page.evaluate(
    () => Boolean(window.shapeUp) && location.search.length < 2 && !window.shapeUp.state().running,
  );
  if (!isThere) return false;
  await page.keyboard.press('Escape');
  await page.evaluate(openAgain, levels);
  // A click selects vertices, a drag moves handles, and the whole model is in the view.
  for (const key of ['1', 'v', 'Home']) await page.keyboard.press(key);
  // The page gives the view the focus of what is gone, but leaves it away from what is there.
  await page.evaluate(() => {
    const view = document.getElementById('viewport');
    view?.focus();
    view?.blur();
  });
  return (await lookOf(page, wanted)) === wanted;
}
