// A mesh without a file: a kind and its sizes, seen in the view while they are typed, kept or taken back.

import { openText } from '../actions.mjs';
import { wavyGrid } from '../meshes.mjs';
import { expect, openPage, sceneOf, state, test, waitForState } from '../support.mjs';

test.use({ pixels: false });

async function openNewMesh(page) {
  await page.getByRole('button', { name: 'Examples' }).click();
  await page.getByRole('menuitem', { name: 'New mesh' }).click();
  return page.getByRole('dialog', { name: 'New mesh' });
}

test('a new mesh follows its sizes, is kept, and is shaped', async ({ page }) => {
  await openPage(page);
  const dialog = await openNewMesh(page);
  await dialog.getByLabel('Shape').selectOption({ label: 'Hypar' });
  await waitForState(page, (now) => now.faces === 144);
  const [first] = await dialog.getByRole('spinbutton').all();
  const length = Number(await first.inputValue());
  await dialog.getByLabel('Unit').selectOption('mm');
  await expect(first).toHaveValue(String(1000 * length));
  await first.fill('-1');
  await expect(dialog.getByRole('button', { name: 'Begin with this' })).toBeDisabled();
  await first.fill(String(2000 * length));
  await expect(dialog.getByText(/faces, .* vertices\./)).toBeVisible();
  await dialog.getByRole('button', { name: 'Begin with this' }).click();
  await expect(dialog).toBeHidden();
  const scene = await sceneOf(page);
  expect(scene.units).toBe('mm');
  const xs = scene.mesh.positions.map(([x]) => x);
  expect(Math.max(...xs) - Math.min(...xs)).toBeCloseTo(2000 * length, 6);
  await page.getByRole('button', { name: 'Make panels flat', exact: true }).click();
  await waitForState(page, (now) => !now.running && now.exact?.met);
});

test('Cancel brings back what was open', async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  const { mesh } = await sceneOf(page);
  const dialog = await openNewMesh(page);
  await waitForState(page, (now) => now.vertices !== 25);
  await dialog.getByRole('button', { name: 'Cancel' }).click();
  await waitForState(page, (now) => now.vertices === 25);
  expect((await sceneOf(page)).mesh).toEqual(mesh);
  expect((await state(page)).running).toBe(false);
});
