// Undo takes back the last thing that was done, and nothing else, also where the page does not show it
// as a step yet.

import type { Page } from '@playwright/test';
import { openText, openVariations, showStep } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { everything, expect, openPage, sceneOf, state, test, waitForState } from '../support.ts';

test.use({ sameDocument: true });

const undoButton = (page: Page) => page.getByRole('button', { name: 'Undo', exact: true });
const positions = (page: Page) => page.evaluate(() => [...window.shapeUp.positions()]);

test('a number typed just before Undo on a new mesh is undone, not the new mesh', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await page.getByRole('button', { name: 'Examples' }).click();
  await page.getByRole('menuitem', { name: 'New mesh' }).click();
  const dialog = page.getByRole('dialog', { name: 'New mesh' });
  await dialog.getByRole('button', { name: 'Create mesh' }).click();
  await expect(dialog).toBeHidden();
  await expect(undoButton(page)).toHaveAttribute('title', /^Undo: New mesh/);
  const { vertices } = await state(page);
  const { weights } = await sceneOf(page);
  const weight = page.getByRole('spinbutton', { name: 'Smooth weight', exact: true });
  await weight.fill('7');
  await weight.press('Control+z');
  await expect(page.getByRole('status')).toHaveText('Undid: Change weights');
  expect((await state(page)).vertices).toBe(vertices);
  expect((await sceneOf(page)).weights).toEqual(weights);
  await weight.press('Control+z');
  await waitForState(page, (now) => now.vertices === 25);
  await expect(page.getByRole('status')).toHaveText('Undid: New mesh');
});

test('a coordinate typed just before Undo is undone, not the step before', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
  await showStep(page, 'Shape');
  await page.getByRole('application', { name: '3D view' }).focus();
  const [x, y] = await page.evaluate(() => window.shapeUp.screen(12) ?? [0, 0]);
  await page.mouse.click(x, y);
  await page.keyboard.press('h');
  await waitForState(page, (now) => now.handles.length === 1);
  const { handles } = await state(page);
  const target = page.getByRole('spinbutton', { name: 'Target x' });
  await target.fill('9');
  await target.press('Control+z');
  await expect(page.getByRole('status')).toHaveText('Undid: Move handle');
  await expect(target).not.toHaveValue('9');
  expect((await state(page)).handles).toEqual(handles);
  await expect(undoButton(page)).toHaveAttribute('title', /Make 1 handle/);
});

test('a variation that is shown is undone, not the step before', async ({ page }) => {
  const panel = await openVariations(page, 6);
  const slider = panel.getByRole('slider').first();
  await expect(slider).toBeVisible();
  // What the card of the panels tries may still join the press.
  await expect(panel.getByText('Move the sliders')).toBeVisible();
  const before = await everything(page);
  await slider.focus();
  for (let i = 0; i < 10; i++) await slider.press('ArrowRight');
  await expect(panel.getByRole('button', { name: 'Keep', exact: true })).toBeEnabled();
  expect(await positions(page)).not.toEqual(before.positions);
  await page.keyboard.press('Control+z');
  await expect(page.getByRole('status')).toHaveText('Undid: Variation');
  await expect.poll(() => everything(page)).toEqual(before);
  await expect(panel.getByRole('slider').first()).toHaveValue('0');
});

test('Undo ends Refine and solve, whenever it is pressed', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(12), 169);
  await page.getByRole('button', { name: 'Make panels flat', exact: true }).click();
  await waitForState(page, (now) => !now.running && now.exact?.met);
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Refine', exact: true }).click();
  const dialog = page.getByRole('dialog', { name: 'Refine' });
  await dialog.getByLabel('How many times').selectOption('3');
  await dialog.getByRole('button', { name: 'Refine and solve' }).click();
  await waitForState(page, (now) => now.faces > 144);
  await page.keyboard.press('Control+z');
  await expect(page.getByRole('button', { name: 'Run', exact: true })).toBeVisible();
  const { faces } = await waitForState(page, (now) => !now.running);
  await page.waitForTimeout(1500);
  expect(await state(page)).toMatchObject({ faces, running: false });
  expect(faces).toBeLessThan(144 * 64);
});
