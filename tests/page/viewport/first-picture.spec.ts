// The first picture, shown before the page can draw, and the presses made meanwhile.

import type { Page } from '@playwright/test';
import { hidePanels } from '../actions.ts';
import { file, wavyGrid } from '../meshes.ts';
import { decodePng, type Picture } from '../picture.ts';
import {
  coloursOfView,
  expect,
  hold,
  looks,
  seeFromTheStart,
  state,
  test,
  waitForState,
} from '../support.ts';

test.use({ fresh: true });

// As a visitor sees the page for the first time.
test.use({ opened: false });

const viewOf = (page: Page) => page.getByRole('application', { name: '3D view' });

// Requests may still be held back when a test ends.
test.afterEach(({ page }) => page.unrouteAll({ behavior: 'ignoreErrors' }));

/** Holds back the view's module only. */
const holdView = (page: Page) => hold(page, '**/view-*.wasm');

/** The fraction of pixels that differ clearly, between two heights given as fractions. */
function differing(a: Picture, b: Picture, [top, bottom]: number[]) {
  const rows = [top, bottom].map((part) => Math.round(part * a.height) * a.width * a.channels);
  let count = 0;
  for (let at = rows[0]; at < rows[1]; at += a.channels) {
    const change = [0, 1, 2].map((i) => Math.abs(a.pixels[at + i] - b.pixels[at + i]));
    if (Math.max(...change) > 48) count += 1;
  }
  return count / ((rows[1] - rows[0]) / a.channels);
}

/** The first picture once it is decoded, or null. */
const shown = (page: Page) =>
  page.evaluate(async () => {
    const image = document.querySelector<HTMLImageElement>('#first-picture img');
    await image?.decode();
    return image && new URL(image.currentSrc).pathname.split('/').pop();
  });

/** The first picture on the screen, and the view that replaces it, as pixels. */
async function replaced(page: Page) {
  await seeFromTheStart(page);
  const release = await holdView(page);
  await page.goto('./');
  await waitForState(page, (now) => now.converged);
  await hidePanels(page);
  await shown(page);
  expect(await coloursOfView(page)).toBeGreaterThan(50);
  const still = decodePng(await viewOf(page).screenshot());
  release();
  await expect(page.locator('#first-picture')).toHaveCount(0);
  expect((await state(page)).renderer).toMatch(/^web/);
  return [still, decodePng(await viewOf(page).screenshot())];
}

for (const colorScheme of ['light', 'dark'] as const) {
  test(
    `the example is on the screen before it can be drawn, ${colorScheme}`,
    looks,
    async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      const [still, drawn] = await replaced(page);
      // Compares the part between the card and the legend. If the pictures were shifted by one
      // pixel, more than a tenth would differ, because of the circles.
      expect(differing(still, drawn, [0.16, 0.68])).toBeLessThan(0.02);
    },
  );
}

/** The left and right end of everything blue, the circles and handles, as fractions of the width. */
function ends({ width, channels, pixels }: Picture) {
  let [left, right] = [width, 0];
  for (let at = 0; at < pixels.length; at += channels) {
    if (pixels[at + 2] - pixels[at] < 60) continue;
    const x = (at / channels) % width;
    [left, right] = [Math.min(left, x), Math.max(right, x)];
  }
  return [left / width, right / width];
}

test(
  'in a window of other proportions the view is nearly as large as its picture',
  { tag: [looks.tag, '@desktop'] },
  async ({ page }) => {
    await page.setViewportSize({ width: 1366, height: 768 });
    const [still, drawn] = (await replaced(page)).map(ends);
    expect(drawn[1] - drawn[0]).toBeGreaterThan(0.8);
    for (const end of [0, 1]) expect(Math.abs(still[end] - drawn[end])).toBeLessThan(0.03);
  },
);

test('it has the chosen theme rather than that of the system, and lets presses through', async ({
  page,
}) => {
  await page.emulateMedia({ colorScheme: 'dark' });
  const release = await holdView(page);
  await page.addInitScript(() => localStorage.setItem('shape-up.theme', 'light'));
  await page.goto('./');
  expect(await shown(page)).toMatch(/^first-(wide|narrow)-light-/);
  await waitForState(page, (now) => now.vertices > 0);
  await page.evaluate(() => (document.documentElement.dataset.theme = 'dark'));
  await expect.poll(() => shown(page)).toMatch(/^first-(wide|narrow)-dark-/);
  await hidePanels(page);
  const below = await viewOf(page).evaluate((view) => {
    const { left, top, width, height } = view.getBoundingClientRect();
    const found = document.elementFromPoint(left + width / 2, top + height / 2);
    return view.contains(found);
  });
  expect(below).toBe(true);
  release();
});

test('presses made before anything has loaded take effect later', async ({ page }) => {
  const releaseScript = await hold(page, '**/*.js');
  const releaseModules = await hold(page, '**/{engine,view}-*.wasm');
  const list = page.waitForResponse(/\/examples\/index\.json$/);
  await page.goto('./', { waitUntil: 'commit' });
  await expect.poll(() => shown(page)).toMatch(/^first-/);
  // On a phone the tools are in place only once the script has loaded.
  const run = page.getByRole('button', { name: 'Run' });
  const early = await run.isVisible();
  if (early) await run.click();
  releaseScript();
  if (!early) await run.click();
  const said = page.getByRole('status');
  await expect(said).toHaveText('Starts when the model is loaded');
  // Also if the list of examples has loaded and only the solver is missing.
  await (await list).finished();
  await expect(said).toHaveText('Starts when the model is loaded');
  releaseModules();
  // A shape that is already exact would leave nothing to run.
  const undo = page.getByRole('button', { name: 'Undo' });
  await expect(undo).toHaveAttribute('title', /^Undo: Run, \d+ iterations/);
  await expect(said).toHaveText(/^Converged after \d+ iterations$/);
});

test('the first picture is removed when another model is opened', async ({ page }) => {
  const release = await holdView(page);
  await page.goto('./');
  await waitForState(page, (now) => now.vertices > 0);
  await expect(page.locator('#first-picture')).toHaveCount(1);
  await hidePanels(page);
  await page.getByLabel('Open file').setInputFiles(file('grid.obj', wavyGrid(4)));
  await waitForState(page, (now) => now.vertices === 25);
  await expect(page.locator('#first-picture')).toHaveCount(0);
  release();
  await waitForState(page, (now) => now.renderer.startsWith('web'));
});
