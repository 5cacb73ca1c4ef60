// Only the essential controls are shown at first; one button, whose state is remembered, shows the
// others. In small windows nothing covers the model while it moves.

import type { Page } from '@playwright/test';
import { openText } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { boxOf, expect, openPage, test, visit, waitForState } from '../support.ts';

test.use({ advanced: false });

const inspector = (page: Page) => page.getByRole('complementary', { name: 'Energies and display' });

test('a first visit shows the essential controls only', async ({ page }) => {
  await visit(page);
  for (const name of [
    ...['Run', 'Step', 'Reset', 'Undo', 'Redo', 'Export', 'Share', 'Add constraint'],
    ...['Make panels circular', 'Make panels flat'],
  ])
    await expect(page.getByRole('button', { name })).toBeVisible();
  await expect(page.getByRole('button', { name: 'Build', exact: true })).toBeVisible();
  await expect(page.getByLabel('Open file')).toBeAttached();
  await expect(inspector(page)).toBeHidden();
  for (const name of ['Refine', 'Edit mesh', 'Write a lesson', 'Edges'])
    await expect(page.getByRole('button', { name })).toBeHidden();
});

test('Advanced shows every control, now and at the next visit', async ({ page }) => {
  await visit(page);
  const advanced = page.getByRole('button', { name: 'Advanced' });
  await expect(advanced).toHaveAttribute('aria-pressed', 'false');
  await advanced.click();
  await expect(advanced).toHaveAttribute('aria-pressed', 'true');
  await expect(inspector(page)).toBeVisible();
  await expect(page.getByRole('button', { name: 'Edit mesh' })).toBeVisible();
  await page.reload();
  await waitForState(page, (now) => now.vertices > 0);
  await expect(inspector(page)).toBeVisible();
  await page.getByRole('button', { name: 'Advanced' }).click();
  await expect(inspector(page)).toBeHidden();
  await page.reload();
  await waitForState(page, (now) => now.vertices > 0);
  await expect(inspector(page)).toBeHidden();
});

test('the button of the suggested next step is the filled one', async ({ page }) => {
  await openPage(page);
  const next = () => page.evaluate(() => document.body.dataset.next);
  await expect.poll(next).toBe('run');
  await openText(page, 'roof.obj', wavyGrid(6), 49);
  await expect.poll(next).toBe('shape');
  await expect(page.getByText('Next: make its panels circular or flat')).toBeVisible();
  const press = page.getByRole('button', { name: 'Make panels flat' });
  await press.click();
  await waitForState(page, (now) => now.converged && !now.running);
  await expect.poll(next).toBe('build');
  const colour = (name: string) =>
    page
      .getByRole('button', { name, exact: true })
      .evaluate((button) => getComputedStyle(button).backgroundColor);
  expect(await colour('Build')).not.toBe(await colour('Run'));
});

test('actions on a selection are offered once something is selected', async ({ page }) => {
  await visit(page);
  await openText(page, 'roof.obj', wavyGrid(6), 49);
  const fix = page.getByRole('button', { name: 'Fix', exact: true });
  await expect(fix).toBeHidden();
  await page.getByRole('application', { name: '3D view' }).focus();
  await page.keyboard.press('Control+A');
  await expect(fix).toBeEnabled();
});

for (const [width, height] of [
  [390, 844],
  [844, 390],
])
  test.describe(`in a window of ${width} by ${height}`, () => {
    test.use({ viewport: { width, height }, hasTouch: true, isMobile: true });

    test('nothing covers a moving model', async ({ page }) => {
      await visit(page);
      await openText(page, 'roof.obj', wavyGrid(6), 49);
      const card = page.getByRole('group', { name: 'Panels', exact: true });
      const opacity = () => card.evaluate((element) => getComputedStyle(element).opacity);
      await expect.poll(opacity).toBe('1');
      // The state in the middle of a gesture, and during a run.
      const view = page.getByRole('application', { name: '3D view' });
      await view.evaluate((element) => (element.dataset.gesture = 'orbit'));
      await expect.poll(opacity).toBe('0');
      await view.evaluate((element) => (element.dataset.gesture = ''));
      await expect.poll(opacity).toBe('1');
      await card.getByRole('button', { name: 'Make panels flat' }).click();
      await expect(card).toContainText('panels are flat within');
      await expect.poll(opacity).toBe('1');
      // The verdict leaves most of the view free.
      const [lies, all] = [await boxOf(card), await boxOf(view)];
      expect(lies.height / all.height).toBeLessThan(0.45);
    });
  });
