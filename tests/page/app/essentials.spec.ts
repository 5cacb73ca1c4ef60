// The page is five steps, of which few are open at first; what is opened stays open. In small windows
// nothing covers the model while it moves.

import type { Page } from '@playwright/test';
import { constraintCount, openText } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { boxOf, expect, openPage, test, visit, waitForState } from '../support.ts';

test.use({ opened: false });

const summary = (page: Page, name: string) => page.locator('summary').filter({ hasText: name });

/** The controls of the first screen that can be seen. */
const controls = (page: Page) =>
  page.evaluate(
    () =>
      [
        ...document.querySelectorAll<HTMLElement>(
          'button, select, input, summary, a[href], [role="slider"]',
        ),
      ].filter((one) => one.checkVisibility({ contentVisibilityAuto: true })).length,
  );

test('a first visit shows five steps, two of them open, and few controls', async ({ page }) => {
  await visit(page);
  for (const name of ['Open or make', 'Shape', 'Move', 'Check', 'Build and share'])
    await expect(page.getByRole('heading', { name, exact: true })).toBeVisible();
  for (const name of [
    ...['Run', 'Step', 'Reset', 'Undo', 'Redo', 'Add constraint', 'Build', 'Export', 'Share'],
    ...['Open your mesh', 'Draw one', 'Make panels circular', 'Make panels flat'],
  ])
    await expect(page.getByRole('button', { name, exact: true })).toBeVisible();
  for (const name of ['New mesh', 'Refine', 'Edit mesh', 'Variations', 'Write a lesson'])
    await expect(page.getByRole('button', { name, exact: true })).toBeHidden();
  await expect(page.getByLabel('Open file')).toBeAttached();
  expect(await controls(page)).toBeLessThanOrEqual(28);
});

test('what is opened is open at the next visit, too', async ({ page }) => {
  await visit(page);
  const colours = page.getByRole('combobox', { name: 'Colour by' });
  const refine = page.getByRole('button', { name: 'Refine' });
  await summary(page, 'Check').click();
  await summary(page, 'Open or make').click();
  await summary(page, 'Change the mesh').click();
  await expect(colours).toBeVisible();
  await expect(refine).toBeVisible();
  await summary(page, 'Shape').click();
  await expect(page.getByRole('button', { name: 'Add constraint' })).toBeHidden();
  await page.reload();
  await waitForState(page, (now) => now.vertices > 0);
  await expect(colours).toBeVisible();
  await expect(refine).toBeVisible();
  await expect(page.getByRole('button', { name: 'Add constraint' })).toBeHidden();
});

test('every command is found by its name', async ({ page }) => {
  await visit(page);
  await page.keyboard.press('Control+k');
  const palette = page.getByRole('dialog', { name: 'Commands' });
  const field = palette.getByRole('combobox', { name: 'Command' });
  await expect(field).toBeFocused();
  await field.fill('panels flat');
  await expect(palette.getByRole('option')).toHaveText([/Make panels flat/]);
  await field.press('Enter');
  await expect(palette).toBeHidden();
  await expect.poll(() => constraintCount(page)).toBe(2);

  await page.getByRole('button', { name: 'Help' }).click();
  await page.getByRole('button', { name: 'All commands' }).click();
  await field.fill('plots');
  await field.press('Enter');
  await expect(page.getByRole('tab', { name: 'Convergence' })).toBeVisible();

  await page.keyboard.press('Control+k');
  await field.fill('nothing is called so');
  await expect(palette.getByRole('status')).toContainText('Nothing is called');
  await field.press('Escape');
  await expect(palette).toBeHidden();
});

test('the button of the suggested next step is the filled one', async ({ page }) => {
  const next = () => page.evaluate(() => document.body.dataset.next);
  const colour = (name: string) =>
    page
      .getByRole('button', { name, exact: true })
      .evaluate((button) => getComputedStyle(button).backgroundColor);
  await visit(page);
  await expect.poll(next).toBe('build');
  const filled = await colour('Build');
  expect(await colour('Run')).not.toBe(filled);
  await openPage(page);
  await expect.poll(next).toBe('run');
  await expect.poll(() => colour('Run')).toBe(filled);
  expect(await colour('Build')).not.toBe(filled);
  await openText(page, 'roof.obj', wavyGrid(6), 49);
  await expect.poll(next).toBe('shape');
  await expect(page.getByText('Next: make its panels flat or circular')).toBeVisible();
  await page.getByRole('button', { name: 'Make panels flat' }).click();
  await waitForState(page, (now) => now.converged && !now.running);
  // Its verdict says that the surface moved far.
  await expect.poll(next).toBe('choose');
  expect(await colour('Build')).not.toBe(filled);

  // Nothing can be run where nothing is constrained.
  await openText(page, 'curve.obj', 'v 0 0 0\nv 1 0 0\nv 2 1 0\nl 1 2 3\n', 3);
  await expect.poll(next).toBe('constrain');
  await expect.poll(() => colour('Add constraint')).toBe(filled);
  expect(await colour('Run')).not.toBe(filled);
  await expect(page.getByText('Next: add a constraint')).toBeVisible();
  await openText(
    page,
    'triangles.obj',
    'v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nf 1 2 3\nf 1 3 4\n',
    4,
  );
  await expect.poll(next).toBe('change');
  expect(await colour('Run')).not.toBe(filled);
  await expect(page.getByText('Next: other panels')).toBeVisible();
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
