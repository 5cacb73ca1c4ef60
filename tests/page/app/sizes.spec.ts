// Window sizes that other tests do not cover: nothing covers the model, and the next action is
// visible.

import type { Page } from '@playwright/test';
import { file, wavyGrid } from '../meshes.ts';
import { openText, showStep, tool } from '../actions.ts';
import { boxOf, expect, openPage, test, waitForState } from '../support.ts';

const SMALL = { width: 1024, height: 768 };
const UPRIGHT = { width: 820, height: 1180 };
const ON_ITS_SIDE = { width: 844, height: 390 };

const view = (page: Page) => page.getByRole('application', { name: '3D view' });
const card = (page: Page) => page.locator('#make-panels-card');
const legend = (page: Page) => page.locator('#legend');

type Box = Awaited<ReturnType<typeof boxOf>>;

/** Whether two boxes overlap. */
const overlap = (a: Box, b: Box) =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

/** The positions of the vertices on the page. */
async function placesOfModel(page: Page) {
  const places = await page.evaluate(() =>
    Array.from({ length: window.shapeUp.state().vertices }, (_, v) => window.shapeUp.screen(v)),
  );
  return places.filter((at) => at !== null);
}

/** The height of the model on the page. */
async function heightOfModel(page: Page) {
  const ys = (await placesOfModel(page)).map(([, y]) => y);
  return Math.max(...ys) - Math.min(...ys);
}

/** The visible controls narrower or lower than 44 px: name and size. */
function smallTargets(page: Page) {
  return page.evaluate((least) => {
    // All but `summary` and labels have a type.
    const all = document.querySelectorAll<HTMLInputElement>(
      'button, a[href], select, input, summary, label.button',
    );
    return [...all].flatMap((one) => {
      // The label can be pressed as well.
      const box = ['checkbox', 'radio', 'file'].includes(one.type)
        ? (one.closest('label') as Element)
        : one;
      const { left, top, right, bottom, width, height } = box.getBoundingClientRect();
      const isSeen = width > 0 && getComputedStyle(one).visibility === 'visible';
      const isInWindow = right > 0 && bottom > 0 && left < innerWidth && top < innerHeight;
      if (!isSeen || !isInWindow || Math.min(width, height) > least - 0.5) return [];
      return [`${one.ariaLabel ?? one.textContent} ${width} × ${height}`];
    });
  }, 44);
}

/**
 * Opens the page and selects everything; checks that all controls are large enough and inside the
 * window.
 */
async function lookAtTargets(page: Page) {
  await openPage(page);
  await expect(legend(page)).toBeVisible();
  expect(await smallTargets(page)).toEqual([]);
  await page.getByRole('button', { name: 'Select', exact: true }).click();
  await page.keyboard.press('Control+a');
  await expect(page.locator('#select-bar')).toBeVisible();
  expect(await smallTargets(page)).toEqual([]);
  const beyond = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
  expect(beyond).toBe(false);
}

/** Opens a roof and makes its panels flat, so that the verdict and the legend are over the view. */
async function makeFlat(page: Page) {
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(6), 49);
  await page.getByRole('button', { name: 'Make panels flat' }).click();
  await waitForState(page, (now) => now.converged && !now.running);
  await expect(card(page)).toBeVisible();
}

/** Opens a dialog by its button in a step. */
async function openBehind(page: Page, button: string, name: string) {
  await tool(page, button);
  return page.getByRole('dialog', { name });
}

for (const opened of [false, true])
  test.describe(opened ? 'with everything open' : 'as it is at first', () => {
    test.use({ opened, viewport: SMALL });

    test('the dialog of a new constraint and the parts panel leave room for the view', async ({
      page,
    }) => {
      await openPage(page);
      await openText(page, 'roof.obj', wavyGrid(6), 49);
      const before = await boxOf(view(page));
      const dialog = await openBehind(page, 'Add constraint', 'New constraint');
      await expect(dialog.getByRole('button', { name: 'Add', exact: true })).toBeInViewport();
      expect(await boxOf(view(page))).toEqual(before);
      await dialog.getByRole('button', { name: 'Close' }).click();

      await page.getByRole('button', { name: 'Make panels flat' }).click();
      await waitForState(page, (now) => now.converged && !now.running);
      await page.getByRole('button', { name: 'Build', exact: true }).click();
      const parts = page.getByRole('region', { name: 'Build: parts and sheets' });
      await expect(parts).toBeVisible();
      await waitForState(page, (now) => now.build !== null);
      const { x, y, width, height } = await boxOf(parts);
      const now = await boxOf(view(page));
      expect([now.x, now.y, now.width]).toEqual([before.x, before.y, before.width]);
      expect(now.y + now.height).toBeLessThanOrEqual(y);
      expect(now.height).toBeGreaterThan(SMALL.height * 0.4);
      expect([x + width <= SMALL.width, y + height <= SMALL.height]).toEqual([true, true]);
      await expect(card(page)).toBeHidden();
      // The model uses the room available.
      await expect.poll(() => heightOfModel(page)).toBeGreaterThan(0.5 * now.height);
    });

    test('the status has room for its words, and the verdict is beside the legend', async ({
      page,
    }) => {
      await makeFlat(page);
      await expect(legend(page)).toBeVisible();
      const [one, other] = [await boxOf(card(page)), await boxOf(legend(page))];
      expect(overlap(one, other)).toBe(false);
      expect(other.x + other.width).toBeLessThanOrEqual(one.x);
      const { width } = await boxOf(page.getByRole('status'));
      expect(width).toBeGreaterThan(120);
    });
  });

test.describe('colours of a mesh that was just opened', () => {
  test.use({ viewport: SMALL });

  test('the whole offer is visible beside the legend', async ({ page }) => {
    await openPage(page);
    await openText(page, 'roof.obj', wavyGrid(6), 49);
    await showStep(page, 'Check');
    await page.getByLabel('Colour by').selectOption('planarity');
    await expect(legend(page)).toBeVisible();
    const [one, other] = [await boxOf(card(page)), await boxOf(legend(page))];
    expect(overlap(one, other)).toBe(false);
    const words = await boxOf(card(page).getByRole('button', { name: 'Something else' }));
    expect(one.x + one.width).toBeLessThanOrEqual(SMALL.width);
    expect(words.x + words.width).toBeLessThanOrEqual(one.x + one.width);
  });
});

test.describe('a presentation', () => {
  test.use({ viewport: SMALL });

  test('the legend is only as high as its content', async ({ page }) => {
    await makeFlat(page);
    const dialog = await openBehind(page, 'Present', 'Presentation');
    await dialog.getByRole('button', { name: 'Add this view' }).click();
    await dialog.getByRole('button', { name: 'Start', exact: true }).click();
    const stage = page.getByRole('region', { name: 'Presentation' });
    await expect(stage.getByRole('heading')).toBeVisible();
    await expect(legend(page)).toBeVisible();
    const { height } = await boxOf(legend(page));
    expect(height).toBeLessThan(200);
    expect(overlap(await boxOf(legend(page)), await boxOf(stage.getByText('1 of 1')))).toBe(false);
  });
});

for (const viewport of [SMALL, UPRIGHT])
  test.describe(`a tablet of ${viewport.width} by ${viewport.height} pixels`, () => {
    test.use({ viewport, hasTouch: true });

    test('touch targets are large enough in every step, and nothing lies beyond the window', async ({
      page,
    }) => {
      await lookAtTargets(page);
      const header = page.getByRole('banner').getByRole('button');
      const ends = await header.evaluateAll((all) =>
        all.map((one) => one.getBoundingClientRect().right),
      );
      expect(Math.max(...ends)).toBeLessThanOrEqual(viewport.width);
      // What a click selects is written.
      for (const word of ['Vertices', 'Edges', 'Faces']) {
        const { width } = await boxOf(page.getByRole('banner').getByText(word, { exact: true }));
        expect(width, word).toBeGreaterThan(20);
      }
      for (const step of ['open', 'shape', 'move', 'check', 'build']) {
        for (const end of ['start', 'end'] as const) {
          await page
            .locator(`#step-${step}`)
            .evaluate((one, block) => one.scrollIntoView({ block }), end);
          expect(await smallTargets(page), `${step}, ${end}`).toEqual([]);
        }
      }
    });

    test('touch targets are large enough beside a verdict, in Build and in dialogs', async ({
      page,
    }) => {
      await makeFlat(page);
      expect(await smallTargets(page)).toEqual([]);
      const [one, other] = [await boxOf(card(page)), await boxOf(legend(page))];
      expect(overlap(one, other)).toBe(false);
      for (const [button, name] of [
        ['Add constraint', 'New constraint'],
        ['Share', 'Share'],
        ['Refine', 'Refine'],
      ]) {
        const dialog = await openBehind(page, button, name);
        expect(await smallTargets(page), name).toEqual([]);
        await dialog.getByRole('button', { name: 'Close' }).first().click();
      }
      await tool(page, 'Build');
      await waitForState(page, (now) => now.build !== null);
      expect(await smallTargets(page)).toEqual([]);
    });
  });

test.describe('a phone in landscape', () => {
  test.use({ viewport: ON_ITS_SIDE, hasTouch: true });

  test('every tool is in the bar, and the parts panel is beside the view', async ({ page }) => {
    await makeFlat(page);
    for (const name of ['Select', 'Drag']) {
      await page.getByRole('button', { name, exact: true }).click();
      const ends = await page
        .getByRole('banner')
        .getByRole('button')
        .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().right));
      expect(Math.max(...ends), name).toBeLessThanOrEqual(ON_ITS_SIDE.width);
    }
    await page.getByRole('button', { name: 'Build', exact: true }).click();
    const parts = page.getByRole('region', { name: 'Build: parts and sheets' });
    await expect(parts).toBeVisible();
    const [one, other] = [await boxOf(parts), await boxOf(view(page))];
    expect(overlap(one, other)).toBe(false);
    expect(other.height).toBeGreaterThan(200);
    await expect(card(page)).toBeHidden();
  });

  test('the legend is below the model', async ({ page }) => {
    await makeFlat(page);
    await card(page).getByRole('button', { name: 'Close' }).click();
    await expect(legend(page)).toBeVisible();
    const { y, height } = await boxOf(legend(page));
    expect(height).toBeLessThan(60);
    await expect
      .poll(async () => Math.max(...(await placesOfModel(page)).map(([, down]) => down)))
      .toBeLessThan(y);
  });

  test('touch targets are large enough, also in an embedded view', async ({ page }) => {
    await lookAtTargets(page);
    await page.goto('./?embed&autoplay');
    await expect(page.getByRole('link', { name: 'Open in Shape-Up' })).toBeVisible();
    expect(await smallTargets(page)).toEqual([]);
  });

  test('the main button of every dialog is visible', async ({ page }) => {
    await makeFlat(page);
    await tool(page, 'Share');
    const share = page.getByRole('dialog', { name: 'Share' });
    await expect(share.getByRole('button', { name: 'Copy link' })).toBeInViewport({ ratio: 1 });
    await share.getByRole('button', { name: 'Close' }).click();
    const refine = await openBehind(page, 'Refine', 'Refine');
    await expect(refine.getByRole('button', { name: 'Refine now' })).toBeInViewport({ ratio: 1 });
    await refine.getByRole('button', { name: 'Close' }).click();
    const lesson = await openBehind(page, 'Write a lesson', 'Lesson');
    await expect(lesson.getByRole('button', { name: 'Save lesson' })).toBeInViewport({ ratio: 1 });
    await lesson.getByRole('button', { name: 'Close' }).click();
    const add = await openBehind(page, 'Add constraint', 'New constraint');
    await expect(add.getByRole('button', { name: 'Add', exact: true })).toBeInViewport({
      ratio: 1,
    });
    await expect(add.getByRole('radio', { name: 'Circle', exact: true })).toBeInViewport();
  });
});

test.describe('a phone in portrait', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true });

  test('a lesson is as wide as the window, and its touch targets are large enough', async ({
    page,
  }) => {
    await openPage(page);
    await page.getByLabel('Open file').setInputFiles(file('roof.obj', wavyGrid(6)));
    await waitForState(page, (now) => now.vertices === 49);
    const lesson = await openBehind(page, 'Write a lesson', 'Lesson');
    const wide = await lesson.evaluate((one) => [
      one.scrollWidth - one.clientWidth,
      Math.max(...[...one.querySelectorAll('*')].map((e) => e.getBoundingClientRect().right)),
    ]);
    expect(wide[0]).toBe(0);
    expect(wide[1]).toBeLessThanOrEqual(390);
    const heights = await lesson
      .locator('label:has(> input)')
      .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().height));
    expect(Math.min(...heights)).toBeGreaterThanOrEqual(44);
  });

  test('touch targets are large enough', async ({ page }) => {
    await lookAtTargets(page);
  });

  test('the curvature card does not cover the model', async ({ page }) => {
    await openPage(page);
    await openText(page, 'roof.obj', wavyGrid(6), 49);
    await tool(page, 'Curvature');
    const curvature = await boxOf(page.getByRole('region', { name: 'Curvature' }));
    const { y, height } = await boxOf(view(page));
    expect(curvature.y).toBeGreaterThan(y + height / 2);
  });
});
