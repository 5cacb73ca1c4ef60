// Starting over in the same document, which takes a third of the time of loading another. The first
// example is opened once more, and all that can be seen of the page is compared with a new one: if
// anything differs (a setting, an open panel, the camera), the page is not used like that. What the
// page remembers and does not show cannot be compared: which rows were opened, and the last operation
// on a mesh. Tests to which that matters do not say `sameDocument`.

import type { Page } from '@playwright/test';

/** Runs in the page: closes what is open and opens the first example by its link. */
async function openAgain() {
  const { shapeUp } = window;
  document.querySelectorAll<HTMLDialogElement>('dialog[open]').forEach((dialog) => dialog.close());
  document
    .querySelectorAll<HTMLDetailsElement>('details[open]')
    .forEach((details) => (details.open = false));
  // The toolbars remember the last button that had the focus.
  document.querySelectorAll('[role=toolbar]').forEach((bar) => {
    bar.querySelector<HTMLElement>('input, button')?.focus();
  });
  (document.activeElement as HTMLElement | null)?.blur();
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
  return JSON.stringify([
    ...[seen, places, { ...shapeUp.state(), last_step_ms: 0 }, activeElement?.localName],
    ...[{ ...documentElement.dataset }, { ...body.dataset }, body.className],
    ...[Object.keys(localStorage).sort(), Object.keys(sessionStorage).sort()],
  ]);
}

/** Largest number of looks at a page, and the time between them in ms, until it is at rest. */
const [LOOKS, EVERY] = [30, 100];

/**
 * What a page looks like that has opened the first example, once it is at rest or as `expected`.
 */
export async function lookOf(page: Page, expected = '') {
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
 * @param wanted what it looks like in a new document
 * @returns whether it looks like that
 */
export async function startOver(page: Page, wanted: string): Promise<boolean> {
  const isThere = await page.evaluate(
    () => Boolean(window.shapeUp) && location.search.length < 2 && !window.shapeUp.state().running,
  );
  if (!isThere) return false;
  await page.keyboard.press('Escape');
  await page.evaluate(openAgain);
  // A click selects vertices, a drag moves handles, and the whole model is in the view.
  for (const key of ['1', 'v', 'Home']) await page.keyboard.press(key);
  return (await lookOf(page, wanted)) === wanted;
}
