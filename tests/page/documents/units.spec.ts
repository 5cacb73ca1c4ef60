// The unit and up axis of a mesh file, which does not state them.

import type { Page } from '@playwright/test';
import { exported, hidePanels, openText, saved, showStep } from '../actions.ts';
import { holdingAnswers } from '../answers.ts';
import { wavyGrid } from '../meshes.ts';
import {
  drawn,
  expect,
  openPage,
  positionOf,
  screenOf,
  state,
  test,
  waitForState,
} from '../support.ts';

test.use({ sameDocument: true });

const guess = (page: Page) =>
  page.getByText('Unit and up axis are not in the file. Are these right?');
const looksRight = (page: Page) => page.getByRole('button', { name: 'Yes', exact: true });
const upOf = (page: Page) => page.evaluate(() => window.shapeUp.scene().up ?? 'z');

test('the guess is shown in the panel, covers nothing, and is written into saved files', async ({
  page,
}) => {
  await openPage(page);
  // Forty other files are remembered, as many as there is room for.
  await page.evaluate(() => {
    const others = Array.from({ length: 40 }, (_, k) => [`${k}.obj`, { units: 'mm', up: 'z' }]);
    localStorage.setItem('shape-up.frames', JSON.stringify(others));
  });
  // The example states its unit and axis.
  await showStep(page, 'Shape');
  await expect(guess(page)).toBeHidden();
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  const corner = await positionOf(page, 24);
  const units = page.getByRole('combobox', { name: 'Unit' });
  const up = page.getByRole('combobox', { name: 'Up axis' });
  await expect(guess(page)).toBeVisible();
  // The guess is a line of the panel: it does not cover the model and needs no answer.
  await expect(
    page.getByRole('complementary', { name: 'Steps' }).locator(guess(page)),
  ).toBeVisible();
  await expect(units).toHaveValue('m');
  await expect(up).toHaveValue('z');
  await units.selectOption('ft');
  await expect(guess(page)).toBeHidden();
  await up.selectOption('y');
  await expect.poll(() => upOf(page)).toBe('y');
  expect(await positionOf(page, 24), 'nothing is rescaled').toEqual(corner);

  const scene = JSON.parse((await saved(page, 'Save scene')).text);
  expect([scene.units, scene.up]).toEqual(['ft', 'y']);
  const mesh = await exported(page, 'OBJ');
  expect(mesh.text).toMatch(/^# units: ft\n# up: y\nv /);

  // The same file opened again gets the same unit, and so does its export.
  for (const [name, text] of [
    ['roof.obj', wavyGrid(4)],
    ['copy.obj', mesh.text],
  ]) {
    await openText(page, 'other.obj', wavyGrid(2), 9);
    await expect(guess(page)).toBeVisible();
    await openText(page, name, text, 25);
    await expect(guess(page)).toBeHidden();
    await expect.poll(() => upOf(page)).toBe('y');
  }
  // Another file of that name is another file: it used to get the unit without a question.
  await openText(page, 'roof.obj', wavyGrid(3), 16);
  await expect(guess(page)).toBeVisible();
  // A guess marked as right is not asked for again.
  await openText(page, 'other.obj', wavyGrid(2), 9);
  await looksRight(page).click();
  await expect(guess(page)).toBeHidden();
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await openText(page, 'other.obj', wavyGrid(2), 9);
  await expect(guess(page)).toBeHidden();
});

test('what is remembered of a file follows Undo and Redo', async ({ page }) => {
  // A unit that was taken back came again with the file, without a question.
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await showStep(page, 'Shape');
  const remembered = () =>
    page.evaluate(() =>
      JSON.parse(localStorage.getItem('shape-up.frames') ?? '[]').map(
        ([, frame]: [string, object]) => frame,
      ),
    );
  await page.getByRole('combobox', { name: 'Unit' }).selectOption('ft');
  const feet = [{ units: 'ft', up: 'z' }];
  await expect.poll(remembered).toEqual(feet);
  await page.keyboard.press('Control+z');
  await expect(guess(page)).toBeVisible();
  await expect.poll(remembered).toEqual([]);
  await page.keyboard.press('Control+Shift+z');
  await expect(guess(page)).toBeHidden();
  await expect.poll(remembered).toEqual(feet);
  // What was confirmed is not asked again: it was, and forgotten.
  await page.keyboard.press('Control+z');
  await looksRight(page).click();
  await page.getByRole('combobox', { name: 'Unit' }).selectOption('ft');
  await expect.poll(remembered).toEqual(feet);
  await page.keyboard.press('Control+z');
  await expect.poll(remembered).toEqual([{ units: 'm', up: 'z' }]);
  await expect(guess(page)).toBeHidden();
});

test('the step with the question about the unit opens with a file, and not with a finer mesh of it', async ({
  page,
}) => {
  // It was opened, and remembered as open, by each refining and its Undo.
  await openPage(page);
  const step = page.locator('#step-open');
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await expect(step).toHaveAttribute('open');
  await page.getByRole('button', { name: 'Refine', exact: true }).click();
  await page.getByRole('button', { name: 'Refine now' }).click();
  await waitForState(page, (now) => now.faces === 64);
  await step.locator('summary').first().click();
  await expect(step).not.toHaveAttribute('open');
  await page.keyboard.press('Control+z');
  await waitForState(page, (now) => now.faces === 16);
  await expect(step).not.toHaveAttribute('open');
  await openText(page, 'other.obj', wavyGrid(2), 9);
  await expect(step).toHaveAttribute('open');
});

test('another axis turns the view, and undo turns it back', async ({ page }) => {
  await openPage(page);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  // The view is framed anew beside the offer.
  await page.getByRole('button', { name: 'Make panels flat' }).first().waitFor();
  await drawn(page);
  const before = await screenOf(page, 0);
  await showStep(page, 'Shape');
  await page.getByRole('combobox', { name: 'Up axis' }).selectOption('y');
  await hidePanels(page);
  await expect.poll(() => page.evaluate(() => window.shapeUp.screen(0))).not.toEqual(before);
  await page.keyboard.press('Control+z');
  await expect.poll(() => upOf(page)).toBe('z');
  await expect.poll(() => page.evaluate(() => window.shapeUp.screen(0))).toEqual(before);
});

test('lengths are shown in the chosen unit', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await showStep(page, 'Shape');
  await page.getByRole('combobox', { name: 'Unit' }).selectOption('ft');
  await showStep(page, 'Check');
  await page.getByLabel('Colour by').selectOption('planarity');
  const worst = page.locator('#numbers').getByText(/^[\d.]+ ft$/);
  await expect(worst.first()).toBeAttached();
  expect((await state(page)).planarity?.max_distance).toBeGreaterThan(0);
});

test('the estimate is in the unit that the user corrects', async ({ page }) => {
  // It stayed in the one that was guessed.
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  const estimate = page.getByRole('group', { name: 'Panels', exact: true }).getByText(/on average/);
  await expect(estimate).toHaveText(/[\d.]+ m on average/);
  await showStep(page, 'Shape');
  await page.getByRole('combobox', { name: 'Unit' }).selectOption('ft');
  await expect(estimate).toHaveText(/[\d.]+ ft on average/);
});

test.describe('with answers that come late', () => {
  test.use({ sameDocument: false });

  test('the unit is remembered for the file in which it was chosen', async ({ page }) => {
    // The file that was opened meanwhile had it the next time, and was a thousand times as large.
    const answers = await holdingAnswers(page);
    await openPage(page);
    await openText(page, 'roof.obj', wavyGrid(4), 25);
    await showStep(page, 'Shape');
    const units = page.getByRole('combobox', { name: 'Unit' });
    await answers.hold('edit');
    await units.selectOption('mm');
    await answers.come('solver: edit');
    await openText(page, 'other.obj', wavyGrid(5), 36);
    await answers.release();
    const remembered = () => page.evaluate(() => localStorage.getItem('shape-up.frames') ?? '[]');
    await expect.poll(async () => JSON.parse(await remembered()).length).toBe(1);
    await expect(guess(page)).toBeVisible();
    await openText(page, 'roof.obj', wavyGrid(4), 25);
    await expect(units).toHaveValue('mm');
    await openText(page, 'other.obj', wavyGrid(5), 36);
    await expect(units).toHaveValue('m');
  });
});
