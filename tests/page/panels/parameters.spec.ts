// Parameters: in the dialog before a constraint is added, and in its row afterwards.

import type { Locator, Page } from '@playwright/test';
import { addConstraint, openText, showStep, tool } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { boxOf, expect, openPage, state, test, waitForState } from '../support.ts';

test.use({ sameDocument: true });

const N = 4;

test.beforeEach(async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), (N + 1) ** 2);
});

/** The first constraint of the scene. */
const constraint = (page: Page) => page.evaluate(() => window.shapeUp.scene().constraints[0]);

const parameter = (place: Locator, name: string) => place.getByRole('group', { name, exact: true });

/** Adds segments on the edges and opens their row. */
async function openRow(page: Page) {
  await addConstraint(page, 'Line segment', 'each edge');
  const row = page.getByRole('list', { name: 'Constraints' }).getByRole('listitem');
  await expect(row.getByRole('combobox')).toHaveCount(0);
  await row.getByRole('button', { name: /parameters/ }).click();
  return row;
}

const LENGTH = 'Line segment on each edge: Length';

test('a constraint is added with the parameters of the dialog', async ({ page }) => {
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Add constraint' }).click();
  const dialog = page.getByRole('dialog', { name: 'New constraint' });
  await dialog.getByRole('radio', { name: 'Line segment', exact: true }).check();
  const length = parameter(dialog, 'Length');
  await length.getByRole('combobox').selectOption('exactly');
  const field = length.getByRole('spinbutton', { name: 'Length' });
  // The initial value suits the mesh.
  expect(Number(await field.inputValue())).toBeGreaterThan(0.9);
  await field.fill('-2');
  await dialog.getByRole('button', { name: 'Add', exact: true }).click();
  await expect(length.getByText(/0/)).toBeVisible();
  await expect(dialog).toBeVisible();
  await field.fill('1.5');
  await dialog.getByRole('button', { name: 'Add', exact: true }).click();
  await expect(dialog).toBeHidden();
  await expect.poll(async () => (await constraint(page))?.length).toBe(1.5);
  await waitForState(page, (now) => now.energy !== null && now.energy.shape > 0.1);
});

test('an error of the solver is shown at the field of the dialog', async ({ page }) => {
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Add constraint' }).click();
  const dialog = page.getByRole('dialog', { name: 'New constraint' });
  await dialog.getByRole('radio', { name: 'Line segment', exact: true }).check();
  const length = parameter(dialog, 'Length');
  await length.getByRole('combobox').selectOption('between');
  await length.getByRole('spinbutton', { name: 'Length from' }).fill('3');
  const to = length.getByRole('spinbutton', { name: 'Length to' });
  await to.fill('2');
  await dialog.getByRole('button', { name: 'Add', exact: true }).click();
  await expect(length.getByText('found 2, expected a number from 3')).toBeVisible();
  await expect(to).toHaveAttribute('aria-invalid', 'true');
  await expect(page.getByRole('alert')).toBeEmpty();
  // An empty field means no limit.
  await to.fill('');
  await dialog.getByRole('button', { name: 'Add', exact: true }).click();
  await expect.poll(async () => (await constraint(page))?.length).toEqual([3, null]);
});

test('a direction is chosen by its axis, and contradictory parameters are reported', async ({
  page,
}) => {
  await addConstraint(page, 'Plane', 'each face');
  const row = page.getByRole('list', { name: 'Constraints' }).getByRole('listitem');
  await row.getByRole('button', { name: /parameters/ }).click();
  const normal = parameter(row, 'Plane on each face: Normal');
  await normal.getByRole('combobox').selectOption('direction');
  await expect.poll(async () => (await constraint(page)).normal).toEqual([0, 0, 1]);
  await normal.getByRole('button', { name: 'along X' }).click();
  await expect.poll(async () => (await constraint(page)).normal).toEqual([1, 0, 0]);
  await expect(normal.getByRole('button', { name: 'along X' })).toHaveAttribute(
    'aria-pressed',
    'true',
  );
  await expect(row.getByText(/normal X/)).toBeVisible();
  const along = parameter(row, 'Plane on each face: Along');
  await along.getByRole('combobox').selectOption('direction');
  await expect(row.getByText(/both .normal. and .along./)).toBeVisible();
  await expect(along.getByRole('combobox')).toHaveValue('nothing');
  expect((await constraint(page)).along).toBeUndefined();
});

test('a parameter in a row takes effect at once, and is one undo step', async ({ page }) => {
  const row = await openRow(page);
  expect((await state(page)).energy?.shape).toBeLessThan(1e-20);
  const length = parameter(row, LENGTH);
  await length.getByRole('combobox').selectOption('exactly');
  await expect.poll(async () => typeof (await constraint(page)).length).toBe('number');
  const field = row.getByRole('spinbutton', { name: LENGTH, exact: true });
  await field.fill('2');
  await field.press('Enter');
  await expect.poll(async () => (await constraint(page)).length).toBe(2);
  await waitForState(page, (now) => now.energy !== null && now.energy.shape > 1);
  // The row stays open, the field keeps the focus, and the row shows values other than the default.
  await expect(field).toBeFocused();
  await expect(row.getByText(/length 2/)).toBeVisible();
  await tool(page, 'Undo');
  await expect(field).not.toHaveValue('2');
  await tool(page, 'Undo');
  await expect(length.getByRole('combobox')).toHaveValue('word rest');
  await expect.poll(async () => (await constraint(page)).length).toBeUndefined();
});

test('lengths and directions are of the unit and the axis as they are now', async ({ page }) => {
  // They used to be those with which the file was opened.
  await showStep(page, 'Shape');
  await page.getByRole('combobox', { name: 'Unit' }).selectOption('mm');
  await page.getByRole('combobox', { name: 'Up axis' }).selectOption('y');
  const row = await openRow(page);
  await parameter(row, LENGTH).getByRole('combobox').selectOption('exactly');
  const field = row.getByRole('spinbutton', { name: LENGTH, exact: true });
  await field.fill('20 cm');
  await field.press('Enter');
  await expect.poll(async () => (await constraint(page)).length).toBe(200);
  await page.getByRole('button', { name: 'Add constraint' }).click();
  const dialog = page.getByRole('dialog', { name: 'New constraint' });
  await dialog.getByRole('radio', { name: 'Plane', exact: true }).check();
  const normal = parameter(dialog, 'Normal');
  await normal.getByRole('combobox').selectOption('direction');
  await expect(normal.getByRole('button', { name: 'along Y' })).toHaveAttribute(
    'aria-pressed',
    'true',
  );
});

test('a refused parameter keeps its old value and shows the reason', async ({ page }) => {
  const row = await openRow(page);
  const length = parameter(row, LENGTH);
  await length.getByRole('combobox').selectOption('between');
  await expect.poll(async () => (await constraint(page)).length).toHaveLength(2);
  const before = (await constraint(page)).length;
  const to = row.getByRole('spinbutton', { name: `${LENGTH} to` });
  await to.fill('0.25');
  await to.press('Enter');
  await expect(length.getByText(/found 0.25, expected a number from/)).toBeVisible();
  await expect(to).toHaveValue(String(before[1]));
  expect((await constraint(page)).length).toEqual(before);
  await expect(page.getByRole('alert')).toBeEmpty();
});

test('the parameters fit into the window', async ({ page }) => {
  const row = await openRow(page);
  await parameter(row, LENGTH).getByRole('combobox').selectOption('between');
  await expect.poll(async () => (await constraint(page)).length).toHaveLength(2);
  const field = row.getByRole('spinbutton', { name: `${LENGTH} to` });
  await field.scrollIntoViewIfNeeded();
  const box = await boxOf(field);
  const panel = await boxOf(page.getByRole('complementary', { name: 'Steps' }));
  expect(box.x).toBeGreaterThanOrEqual(panel.x);
  expect(box.x + box.width).toBeLessThanOrEqual(panel.x + panel.width);
});

test('an expression in a number field is refused with words, and changes nothing', async ({
  page,
}) => {
  // Browsers leave the sign out of a field for numbers: it used to become 20.5.
  const row = await openRow(page);
  const weight = row.getByRole('spinbutton', { name: /weight/i });
  await weight.fill('');
  await page.keyboard.type('2*0.5');
  await page.keyboard.press('Enter');
  const words = await weight.evaluate((field: HTMLInputElement) => field.validationMessage);
  expect(words).toBe('“2*0.5” is not a number. Expected 1.5, 1/3 or +0.5.');
  await weight.blur();
  await expect(weight).toHaveValue('1');
  expect((await constraint(page))?.weight ?? 1).toBe(1);
  await weight.fill('3');
  await page.keyboard.press('Enter');
  await expect.poll(async () => (await constraint(page))?.weight).toBe(3);
});
