// From a coarse mesh to a fine one: the forecast of the dialog is met, sets and handles are carried
// over, each level is solved, and undo restores the opened mesh.

import type { Page } from '@playwright/test';
import { openText, showStep } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { expect, openPage, sceneOf, state, test, waitForState } from '../support.ts';

test.use({ sameDocument: true });

const N = 4;
const VERTICES = (N + 1) ** 2;
const FACES = N ** 2;

async function openRefine(page: Page) {
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Refine', exact: true }).click();
  return page.getByRole('dialog', { name: 'Refine' });
}

test('a mesh is refined as forecast, with its scene, and undone in one step', async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), VERTICES);
  const before = await page.evaluate(() => [...window.shapeUp.positions()]);
  const dialog = await openRefine(page);
  await expect(dialog.getByText(`${FACES} faces become 64 faces, with 81 vertices.`)).toBeVisible();
  // Without constraints there is nothing to solve.
  await expect(dialog.getByRole('button', { name: 'Refine and solve' })).toBeHidden();
  // Each choice shows the resulting panels.
  await expect(dialog.getByLabel('How many times').locator('option').nth(2)).toHaveText(
    /^Three times: 1024 faces of about 0\.1\d+( m)?$/,
  );
  await dialog.getByLabel('How many times').selectOption('2');
  await dialog.getByLabel('New faces').selectOption('linear');
  await expect(dialog.getByText('256 faces, with 289 vertices')).toBeVisible();
  await dialog.getByRole('button', { name: 'Refine now' }).click();
  await waitForState(page, (now) => now.faces === 256 && now.vertices === 289);
  await expect(page.getByRole('status')).toContainText('Refined to 256 faces');
  expect((await state(page)).moved?.max).toBeLessThan(1e-12);
  const scene = await sceneOf(page);
  expect(scene.mesh.faces).toHaveLength(256);
  expect(scene.mesh.positions.slice(0, VERTICES).flat()).toEqual(before);
  // The saved scene opens with the same content.
  await page.evaluate(
    (text) => window.shapeUp.open(text, 'fine.shapeup.json'),
    JSON.stringify(scene),
  );
  expect((await sceneOf(page)).mesh).toEqual(scene.mesh);
});

test('each level is solved, and undo goes back level by level', async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), VERTICES);
  await page.getByRole('button', { name: 'Make panels flat', exact: true }).click();
  await waitForState(page, (now) => !now.running && now.exact?.met);
  const dialog = await openRefine(page);
  await dialog.getByLabel('How many times').selectOption('2');
  const closeTo = dialog.getByLabel('Each level stays close to');
  await closeTo.selectOption({ label: 'The original: nearer to it' });
  await expect(dialog.getByText('“Moved” is measured from the refined original.')).toBeVisible();
  await dialog.getByRole('button', { name: 'Refine and solve' }).click();
  await waitForState(page, (now) => now.faces === 256 && !now.running && now.exact?.met);
  await expect(page.getByRole('status')).toContainText('All 256 panels are flat within');
  const undo = page.getByRole('button', { name: 'Undo', exact: true });
  await undo.click();
  await waitForState(page, (now) => now.faces === 64);
  await undo.click();
  await waitForState(page, (now) => now.faces === 16 && now.vertices === 25);
  await page.getByRole('button', { name: 'Redo', exact: true }).click();
  await waitForState(page, (now) => now.faces === 64);
});

test('each solved level is the original of the next, and undo restores the first', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), VERTICES);
  await page.getByRole('button', { name: 'Make panels flat', exact: true }).click();
  const solved = await waitForState(page, (now) => !now.running && now.exact?.met);
  const dialog = await openRefine(page);
  await expect(dialog.getByText('from the last level that was solved')).toBeVisible();
  await dialog.getByLabel('How many times').selectOption('2');
  await dialog.getByRole('button', { name: 'Refine and solve' }).click();
  const fine = await waitForState(
    page,
    (now) => now.faces === 256 && !now.running && now.exact?.met,
  );
  expect(fine.moved?.max).toBeLessThan(0.5 * (solved.moved?.max ?? NaN));
  const undo = page.getByRole('button', { name: 'Undo', exact: true });
  await undo.click();
  await waitForState(page, (now) => now.faces === 64);
  await undo.click();
  const again = await waitForState(page, (now) => now.faces === 16);
  expect(again.moved?.max).toBeCloseTo(solved.moved?.max ?? NaN, 12);
});

test('Pause also stops it between two levels', async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), VERTICES);
  await page.getByRole('button', { name: 'Make panels flat', exact: true }).click();
  await waitForState(page, (now) => !now.running && now.exact?.met);
  const dialog = await openRefine(page);
  await dialog.getByLabel('How many times').selectOption('4');
  // Pressed in the page as soon as a level is announced, when nothing runs.
  await page.evaluate(() => {
    const status = document.querySelector('[role=status]') as HTMLElement;
    const pause = () =>
      [...document.querySelectorAll('button')].find((it) => it.textContent.trim() === 'Pause');
    new MutationObserver((_, observer) => {
      if (!status.textContent.startsWith('Refined to 64')) return;
      observer.disconnect();
      pause()?.click();
    }).observe(status, { childList: true, characterData: true, subtree: true });
  });
  await dialog.getByRole('button', { name: 'Refine and solve' }).click();
  await expect(page.getByRole('status')).toContainText('; stopped');
  await expect(page.getByRole('button', { name: 'Run', exact: true })).toBeVisible();
  const stopped = await waitForState(page, (now) => !now.running);
  expect(stopped.faces).toBeLessThanOrEqual(FACES * 16);
});
