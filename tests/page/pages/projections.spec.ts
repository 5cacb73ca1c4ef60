// The page about projections: by mouse, by keyboard, and in words.

import type { Page } from '@playwright/test';
import { boxOf, expect, known, test } from '../support.ts';

/** φ after each half step, from the table beside the bars. */
async function proximities(page: Page) {
  const cells = await page.locator('#rows tr td:last-child').allTextContents();
  return cells.map((text) => Number(text.replace('−', '-')));
}

const point = (page: Page) => page.getByRole('button', { name: /^Point at/ });

/** Presses Step so many times; returns what was said of each step. */
const stepped = (page: Page, times: number) =>
  page.getByRole('button', { name: 'Step' }).evaluate((step: HTMLElement, count) => {
    return Array.from({ length: count }, () => {
      step.click();
      return document.querySelector('[role="status"]')?.textContent ?? '';
    });
  }, times);

test('steps never increase the sum, though a term may grow, and each is described in words', async ({
  page,
}) => {
  await page.goto('./projections.html');
  const step = page.getByRole('button', { name: 'Step' });
  const said = page.getByRole('status');
  await expect(said).toContainText('The point is at proximity');
  await step.click();
  await expect(said).toContainText('Step I, iteration 1: the nearest place on each set.');
  await step.click();
  await expect(said).toContainText('Step II, iteration 1: the point moves to their weighted mean.');
  const heard = await stepped(page, 10);
  expect(heard.some((text) => text.includes('grew, φ did not'))).toBe(true);
  const sums = await proximities(page);
  expect(sums).toHaveLength(12);
  for (let k = 1; k < sums.length; k++) expect(sums[k]).toBeLessThanOrEqual(sums[k - 1]);
  expect(sums.at(-1)).toBeLessThan(0.5 * sums[0]);
  await expect(page.getByRole('img', { name: /^φ falls from/ })).toBeVisible();
});

test('moving the point by mouse or keys clears the steps, and Reset restores it', async ({
  page,
}) => {
  await page.goto('./projections.html');
  const before = known(await point(page).getAttribute('aria-label'));
  await page.getByRole('button', { name: 'Step' }).click();
  await point(page).focus();
  await page.keyboard.press('ArrowLeft');
  const moved = await point(page).getAttribute('aria-label');
  expect(moved).not.toBe(before);
  expect(await proximities(page)).toEqual([]);

  const box = await boxOf(page.getByRole('group', { name: 'The point and its constraint sets' }));
  await page.mouse.move(box.x + 0.3 * box.width, box.y + 0.4 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
  await page.mouse.up();
  await expect(point(page)).toHaveAccessibleName(/^Point at (49|50)\.\d, (29|30)\.\d/);
  await page.getByRole('button', { name: 'Reset' }).click();
  await expect(point(page)).toHaveAccessibleName(before);
});

test('disjoint sets leave a residual, and weights decide where the point ends', async ({
  page,
}) => {
  await page.goto('./projections.html');
  await page.getByRole('radio', { name: 'do not meet' }).check();
  await stepped(page, 40);
  const rest = (await proximities(page)).at(-1);
  expect(rest).toBeGreaterThan(10);
  const before = await point(page).getAttribute('aria-label');
  const weight = page.getByRole('slider', { name: 'Weight of the circle' });
  await weight.focus();
  await page.keyboard.press('End');
  await stepped(page, 40);
  expect(await point(page).getAttribute('aria-label')).not.toBe(before);
});

test.describe('with a clock of its own', () => {
  test.use({ fresh: true });

  test('Play continues until it is paused or has converged', async ({ page }) => {
    await page.clock.install();
    await page.goto('./projections.html');
    await page.getByRole('button', { name: 'Play' }).click();
    await expect(page.getByRole('status')).toContainText('iteration 2');
    await page.getByRole('button', { name: 'Pause' }).click();
    const sums = await proximities(page);
    await page.clock.runFor(10_000);
    expect(await proximities(page)).toEqual(sums);

    await page.getByRole('button', { name: 'Play' }).click();
    await page.clock.runFor(600_000);
    await expect(page.getByRole('status')).toContainText('The point has arrived.');
    await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
  });
});
