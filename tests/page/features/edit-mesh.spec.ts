// Editing the mesh: the forecast of the dialog is met, on the selection too, and undo works.

import type { Page } from '@playwright/test';
import { hidePanels, openText, showStep } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { expect, openPage, sceneOf, screenOf, test, waitForState } from '../support.ts';

test.use({ sameDocument: true });

const N = 4;
const VERTICES = (N + 1) ** 2;

async function openEdit(page: Page) {
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Edit mesh', exact: true }).click();
  return page.getByRole('dialog', { name: 'Edit mesh' });
}

test('the dialog forecasts the result of each operation, and undo goes back step by step', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), VERTICES);
  const before = (await sceneOf(page)).mesh;
  let dialog = await openEdit(page);
  // Starts with an operation for quads. There are no triangles to pair, and the dialog says so.
  await expect(dialog.getByLabel('Operation')).toHaveValue('dual');
  await dialog.getByLabel('Operation').selectOption('Triangles to quads');
  await expect(
    dialog.getByText('Not possible yet: this needs two triangles side by side'),
  ).toBeVisible();
  await expect(dialog.getByRole('button', { name: 'Apply' })).toBeDisabled();
  await dialog.getByLabel('Operation').selectOption('Dual');
  await expect(dialog.getByText('16 faces become 25 quads, with 36 vertices.')).toBeVisible();
  await dialog.getByRole('button', { name: 'Apply' }).click();
  await waitForState(page, (now) => now.faces === 25 && now.vertices === 36);
  await expect(page.getByRole('status')).toContainText('Dual: 16 faces became 25 faces');

  dialog = await openEdit(page);
  await dialog.getByLabel('Operation').selectOption('Extrude the boundary');
  await dialog.getByLabel('Outward').fill('0.5');
  await expect(dialog.getByText('25 faces become 45 quads')).toBeVisible();
  await dialog.getByRole('button', { name: 'Apply' }).click();
  await waitForState(page, (now) => now.faces === 45);

  const undo = page.getByRole('button', { name: 'Undo', exact: true });
  await undo.click();
  await waitForState(page, (now) => now.faces === 25);
  await undo.click();
  await waitForState(page, (now) => now.faces === 16);
  expect((await sceneOf(page)).mesh).toEqual(before);
});

test('selected faces are deleted, the hole is filled, and losses are shown beforehand', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), VERTICES);
  const { mesh } = await sceneOf(page);
  const scene = {
    ...{ format: 'shape-up-scene', version: 1, mesh },
    constraints: [{ kind: 'plane', on: 'faces', require: 'exact' }],
    handles: [{ vertices: [0], fixed: true }],
  };
  await page.evaluate((scene) => window.shapeUp.open(scene), scene);
  const dialog = await openEdit(page);
  await dialog.getByLabel('Operation').selectOption('Delete faces');
  await expect(dialog.getByText('Not possible yet: this needs selected faces.')).toBeVisible();
  await dialog.getByRole('button', { name: 'Close' }).click();

  // Selects the faces in the corner and in the middle.
  await hidePanels(page);
  await page.keyboard.press('3');
  const middleOf = async (corners: number[]): Promise<[number, number]> => {
    const at = await Promise.all(corners.map((corner) => screenOf(page, corner)));
    const mean = (axis: number) => at.reduce((sum, point) => sum + point[axis], 0) / at.length;
    return [mean(0), mean(1)];
  };
  await page.mouse.click(...(await middleOf(mesh.faces[0])));
  await page.keyboard.down('Shift');
  await page.mouse.click(...(await middleOf(mesh.faces[5])));
  await page.keyboard.up('Shift');
  await expect(page.getByRole('status')).toHaveText('2 faces selected');
  // From the context menu of the selection.
  await page.mouse.click(...(await middleOf(mesh.faces[5])), { button: 'right' });
  await page.getByRole('menuitem', { name: 'Edit mesh' }).click();
  const again = page.getByRole('dialog', { name: 'Edit mesh' });
  await again.getByLabel('Operation').selectOption('Delete faces');
  await expect(again.getByText('16 faces become 14 quads, with 24 vertices.')).toBeVisible();
  await expect(again.getByText('1 handle on vertices that no longer exist')).toBeVisible();
  await again.getByRole('button', { name: 'Apply' }).click();
  await waitForState(page, (now) => now.faces === 14 && now.handles.length === 0);
  expect((await sceneOf(page)).constraints).toHaveLength(1);
  // The edited mesh can be solved.
  await page.getByRole('button', { name: 'Run', exact: true }).click();
  await waitForState(page, (now) => !now.running && now.exact?.met);

  const fill = await openEdit(page);
  await fill.getByLabel('Operation').selectOption('Fill holes');
  await expect(fill.getByText('14 faces become 15 quads')).toBeVisible();
  await fill.getByRole('button', { name: 'Apply' }).click();
  await waitForState(page, (now) => now.faces === 15);
});
