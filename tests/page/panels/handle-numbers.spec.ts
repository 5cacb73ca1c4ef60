// Handles by numbers: several at once, relative values, and room for the digits.

import type { Locator, Page } from '@playwright/test';
import { addConstraint, downloaded, hidePanels, openText, showStep } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { expect, openPage, screenOf, settled, state, test, waitForState } from '../support.ts';

const N = 6;
const VERTICES = (N + 1) ** 2;
const MIDDLE = (VERTICES - 1) / 2;

declare global {
  interface Window {
    /** Sends the message that the test holds back. */
    end: () => void;
    sent: string[];
  }
}

test.use({ sameDocument: true });

const details = (page: Page) => page.getByRole('group', { name: 'Selected handles' });
const target = (page: Page, axis: string) =>
  details(page).getByRole('spinbutton', { name: `Target ${axis}` });
const undoButton = (page: Page) => page.getByRole('button', { name: 'Undo' });
const targets = async (page: Page) => (await state(page)).handles.map((handle) => handle.target);

async function enter(field: Locator, text: string) {
  await field.fill(text);
  await field.press('Enter');
}

/** Makes the vertices handles and leaves them selected. */
async function makeHandles(page: Page, vertices: number[]) {
  await hidePanels(page);
  for (const vertex of vertices) {
    if (vertex !== vertices[0]) await page.keyboard.down('Shift');
    await page.mouse.click(...(await screenOf(page, vertex)));
    await page.keyboard.up('Shift');
  }
  await page.keyboard.press('h');
  await waitForState(page, (now, count) => now.handles.length === count, vertices.length);
  await showStep(page, 'Shape');
  await expect(details(page)).toBeVisible();
}

async function open(page: Page, text = wavyGrid(N)) {
  await openPage(page);
  await openText(page, 'grid.obj', text, VERTICES);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
}

test('a coordinate is set for all selected handles in one step', async ({ page }) => {
  await open(page);
  await addConstraint(page, 'Plane', 'each face');
  await makeHandles(page, [MIDDLE, MIDDLE + 1]);
  const before = await targets(page);
  expect(before[0][0]).not.toBe(before[1][0]);
  // Common values are shown, differing ones are marked as mixed.
  await expect(target(page, 'x')).toHaveValue('');
  await expect(target(page, 'x')).toHaveAttribute('placeholder', 'mixed');
  expect(Number(await target(page, 'y').inputValue())).toBeCloseTo(before[0][1], 3);

  await enter(target(page, 'z'), '7.5');
  await expect.poll(() => targets(page)).toEqual(before.map(([x, y]) => [x, y, 7.5]));
  await expect(page.getByRole('status')).toHaveText('2 handles moved');
  await expect(target(page, 'z')).toHaveValue(/^7\.50*$/);
  await expect(undoButton(page)).toHaveAttribute('title', /Move 2 handles/);
  await undoButton(page).click();
  await expect.poll(() => targets(page)).toEqual(before);
  await expect(undoButton(page)).toHaveAttribute('title', /Make 2 handles/);
  await expect(target(page, 'z')).not.toHaveValue(/7\.5/);
});

test('a number with a sign moves relatively; fractions and units are accepted', async ({
  page,
}) => {
  await open(page);
  await makeHandles(page, [MIDDLE, MIDDLE + 1]);
  const before = await targets(page);
  const shifted = (by: number) => before.map(([x, y, z]) => [x + by, y, z]);
  const near = async (expected: number[][]) => {
    const flat = (await targets(page)).flat();
    return expected.flat().every((value, i) => Math.abs(value - flat[i]) < 1e-12);
  };
  await enter(target(page, 'x'), '+0.5');
  await expect.poll(() => near(shifted(0.5))).toBe(true);
  await enter(target(page, 'x'), '+20cm');
  await expect.poll(() => near(shifted(0.7))).toBe(true);
  await enter(target(page, 'x'), '+-1/5');
  await expect.poll(() => near(shifted(0.5))).toBe(true);
  await enter(target(page, 'y'), '-1/4');
  await expect.poll(() => near(before.map(([x, , z]) => [x + 0.5, -0.25, z]))).toBe(true);

  const now = await targets(page);
  await enter(target(page, 'z'), 'high');
  const problem = () =>
    target(page, 'z').evaluate((field: HTMLInputElement) => field.validationMessage);
  expect(await problem()).toMatch(/“high” is not a length/);
  await target(page, 'z').press('Escape');
  expect(await problem()).toBe('');
  await expect(target(page, 'z')).not.toHaveValue('high');
  await expect(details(page), 'they are still selected').toBeVisible();
  expect(await targets(page)).toEqual(now);
});

test('two coordinates entered in quick succession both take effect', async ({ page }) => {
  await open(page);
  await makeHandles(page, [MIDDLE]);
  const [[, , z]] = await targets(page);
  await target(page, 'x').fill('1.25');
  await target(page, 'x').press('Tab');
  await page.keyboard.type('2.75');
  await page.keyboard.press('Enter');
  await expect.poll(() => targets(page)).toEqual([[1.25, 2.75, z]]);
  await expect(undoButton(page)).toHaveAttribute('title', /Move handle/);
});

test('a held arrow key moves the handle by one step of undo', async ({ page }) => {
  // Each repeat of the key was one.
  await open(page);
  await makeHandles(page, [MIDDLE]);
  const before = await targets(page);
  await target(page, 'z').focus();
  for (let time = 0; time < 5; time++) await page.keyboard.down('ArrowUp');
  await page.keyboard.up('ArrowUp');
  const z = async () => (await targets(page))[0][2];
  await expect.poll(z).toBeCloseTo(before[0][2] + 0.05, 3);
  await undoButton(page).click();
  await expect.poll(() => targets(page)).toEqual(before);
});

test('an arrow key moves a handle visibly whatever the size of the mesh', async ({ page }) => {
  // What was shown was rounded to 0 decimals and read again: of steps of 1 cm, none moved it.
  const large = (_: string, ...at: string[]) => `v ${at.map((x) => 1e4 * Number(x)).join(' ')}`;
  await open(page, wavyGrid(N).replace(/^v (\S+) (\S+) (\S+)$/gm, large));
  await page.getByRole('combobox', { name: 'Unit' }).selectOption('m');
  await makeHandles(page, [MIDDLE]);
  const [[, , before]] = await targets(page);
  await target(page, 'z').focus();
  for (let time = 0; time < 3; time++) await page.keyboard.press('ArrowUp');
  const z = async () => Math.round((await targets(page))[0][2] - before);
  await expect.poll(z).toBe(3);
});

test('a drag that begins while a number is typed is a step of its own', async ({ page }) => {
  // It ended with the move to the number, and the handle jumped there.
  await open(page);
  await makeHandles(page, [MIDDLE]);
  const [[, y, z]] = await targets(page);
  const [left, top] = await screenOf(page, MIDDLE);
  await target(page, 'x').fill('0.1');
  await page.mouse.move(left, top);
  await page.mouse.down();
  await page.mouse.move(left + 30, top, { steps: 3 });
  // Longer than the mesh follows a number.
  await page.waitForTimeout(600);
  await page.mouse.move(left + 60, top, { steps: 3 });
  await page.mouse.up();
  await expect(undoButton(page)).toHaveAttribute('title', /Move handle/);
  expect((await targets(page))[0][0]).not.toBeCloseTo(0.1, 6);
  await undoButton(page).click();
  await expect.poll(() => targets(page)).toEqual([[0.1, y, z]]);
});

test('what is saved right after a number has the mesh that has followed it', async ({ page }) => {
  // The messages to the solver, in their order: names, and phases of a drag.
  await page.addInitScript(() => {
    window.sent = [];
    const postMessage = Worker.prototype.postMessage as (...message: unknown[]) => void;
    Worker.prototype.postMessage = function (...message) {
      window.sent.push(message[0].given?.[0]?.phase ?? message[0].name);
      postMessage.apply(this, message);
    };
  });
  await open(page);
  await makeHandles(page, [MIDDLE]);
  await target(page, 'z').fill('7.5');
  await page.evaluate(() => (window.sent = []));
  await downloaded(page, () => page.keyboard.press('Control+s'));
  const sent = await page.evaluate(() => window.sent);
  expect(sent.filter((name) => ['start', 'end', 'scene'].includes(name))).toEqual([
    ...['start', 'end', 'scene'],
  ]);
});

test('undo takes back a number for good, even while the mesh still follows it', async ({
  page,
}) => {
  // The message that ends the move is held back until the test releases it.
  await page.addInitScript(() => {
    const postMessage = Worker.prototype.postMessage as (...message: unknown[]) => void;
    Worker.prototype.postMessage = function (...message) {
      if (message[0].given?.[0]?.phase !== 'end') return postMessage.apply(this, message);
      window.end = () => postMessage.apply(this, message);
    };
  });
  await open(page);
  await makeHandles(page, [MIDDLE]);
  const before = await targets(page);
  await enter(target(page, 'z'), '7.5');
  await page.waitForFunction(() => window.end);
  await undoButton(page).click();
  await expect(page.getByRole('status')).toHaveText('Undid: Move handle');
  await page.evaluate(() => window.end());
  await page.getByRole('button', { name: 'Step' }).click();
  await waitForState(page, (now) => now.iteration === 1);
  expect(await targets(page)).toEqual(before);
});

test('weight, Soft and Fixed apply to all selected handles', async ({ page }) => {
  await open(page);
  await makeHandles(page, [MIDDLE, MIDDLE + 1]);
  await hidePanels(page);
  await page.mouse.click(...(await screenOf(page, MIDDLE)));
  await waitForState(page, (now) => now.selection.vertices.length === 1);
  await showStep(page, 'Shape');
  const weight = details(page).getByRole('spinbutton', { name: 'Weight of the handle' });
  await enter(weight, '7');
  await waitForState(page, (now) => now.handles.some((handle) => handle.weight === 7));

  await hidePanels(page);
  await page.keyboard.down('Shift');
  await page.mouse.click(...(await screenOf(page, MIDDLE + 1)));
  await page.keyboard.up('Shift');
  await waitForState(page, (now) => now.selection.vertices.length === 2);
  await showStep(page, 'Shape');
  await expect(weight).toHaveValue('');
  await expect(weight).toHaveAttribute('placeholder', 'mixed');
  await enter(weight, '12');
  await waitForState(page, (now) => now.handles.every((handle) => handle.weight === 12));
  await expect(undoButton(page)).toHaveAttribute('title', /Weight of 2 handles/);

  const soft = details(page).getByRole('button', { name: 'Soft' });
  await expect(soft).toHaveAttribute('aria-pressed', 'true');
  // Handles that are already soft keep their weight.
  await soft.click();
  await settled(page);
  expect((await state(page)).handles.map((handle) => handle.weight)).toEqual([12, 12]);
  await details(page).getByRole('button', { name: 'Fixed' }).click();
  await waitForState(page, (now) => now.handles.every((handle) => handle.fixed));
  await expect(undoButton(page)).toHaveAttribute('title', /Fix 2 vertices/);
  await expect(weight).toBeHidden();
});

// A building some hundred metres long, at the coordinates of a survey.
for (const far of [-321, -4321]) {
  test(`the fields have room for the digits at ${far} m`, async ({ page }) => {
    const fits = () =>
      details(page)
        .locator('.target')
        .getByRole('spinbutton')
        .evaluateAll((fields) => fields.map((field) => field.scrollWidth <= field.clientWidth));
    const place = (_: string, ...at: string[]) => {
      const [x, y, z] = at.map(Number);
      return `v ${far + 20.123456 * x} ${20 * y + 0.000123} ${20 * z}`;
    };
    await open(page, wavyGrid(N).replace(/^v (\S+) (\S+) (\S+)$/gm, place));
    await makeHandles(page, [MIDDLE]);
    await expect(target(page, 'x')).toHaveValue(/^-\d{3,4}\.\d{3}$/);
    expect(await fits()).toEqual([true, true, true]);
    await enter(target(page, 'y'), '-123456.789');
    await expect(target(page, 'y')).toHaveValue('-123456.789');
    expect(await fits()).toEqual([true, true, true]);
    await page.setViewportSize({ width: 390, height: 844 });
    await showStep(page, 'Move');
    await expect.poll(fits, 'on a phone').toEqual([true, true, true]);
  });
}
