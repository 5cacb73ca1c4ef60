// The mouse buttons as in other programs, and the views that were looked through before.

import type { Page } from '@playwright/test';
import { openGrid } from '../actions.ts';
import { boxOf, expect, screenOf, state, test } from '../support.ts';

type Button = 'left' | 'middle' | 'right';

const camera = (page: Page) => page.evaluate(() => window.shapeUp.camera() as number[]);
const view = (page: Page) => page.getByRole('application', { name: '3D view' });

/** Sets whose mouse buttons move the camera. */
async function setMouse(page: Page, label: string) {
  const menu = page.getByRole('button', { name: 'Views', exact: true });
  await menu.click();
  await page.getByLabel('Mouse as').selectOption({ label });
  await menu.click();
  await expect(page.getByLabel('Mouse as')).toBeHidden();
}

/** Drags beside the model with a button, and returns what that did to the camera. */
async function drag(page: Page, button: Button, ...keys: string[]) {
  const before = await camera(page);
  const { x, y, width, height } = await boxOf(view(page));
  const [at, to] = [
    [x + 0.02 * width, y + 0.3 * height],
    [x + 0.1 * width, y + 0.4 * height],
  ];
  await page.mouse.move(at[0], at[1]);
  for (const key of keys) await page.keyboard.down(key);
  await page.mouse.down({ button });
  await page.mouse.move(to[0], to[1], { steps: 4 });
  await page.mouse.up({ button });
  for (const key of keys) await page.keyboard.up(key);
  return { before, after: await camera(page) };
}

test('the right and the middle button do what they do in Rhino, on web pages and in Blender', async ({
  page,
}) => {
  await openGrid(page, 4);
  /** Whether the camera turned, came nearer, or moved sideways. */
  const done = async (button: Button, ...keys: string[]) => {
    const { before, after } = await drag(page, button, ...keys);
    const differs = (from: number, to: number) =>
      before.slice(from, to).some((value, i) => Math.abs(value - after[from + i]) > 1e-6);
    // Pivot, distance, turn and tilt: see `camera_numbers` of the view.
    if (differs(4, 6)) return 'orbit';
    if (differs(3, 4)) return 'zoom';
    return differs(0, 3) ? 'pan' : 'nothing';
  };
  expect(await done('left')).toBe('orbit');
  expect(await done('left', 'Shift'), 'beside the model').toBe('pan');
  expect(await done('right')).toBe('orbit');
  expect(await done('right', 'Shift')).toBe('pan');
  await page.keyboard.press('b');
  expect(await done('right'), 'in the Select tool').toBe('orbit');
  await page.keyboard.press('v');
  expect(await done('middle')).toBe('pan');
  await setMouse(page, 'on web pages');
  expect(await done('left')).toBe('orbit');
  expect(await done('right')).toBe('pan');
  expect(await done('middle')).toBe('zoom');
  await setMouse(page, 'in Blender');
  expect(await done('middle')).toBe('orbit');
  expect(await done('middle', 'Shift')).toBe('pan');
  expect(await done('middle', 'Control')).toBe('zoom');
  await setMouse(page, 'in Rhino');
});

test('Backspace goes back to the view before, and with Shift forward', async ({ page }) => {
  await openGrid(page, 4);
  const first = await camera(page);
  await page.waitForTimeout(500);
  await page.keyboard.press('Shift+Digit1');
  await page.waitForTimeout(900);
  const top = await camera(page);
  expect(top).not.toEqual(first);
  const isAt = (wanted: number[]) => async () => {
    const now = await camera(page);
    return Math.max(...now.map((value, i) => Math.abs(value - wanted[i]))) < 1e-3;
  };
  await view(page).focus();
  await page.keyboard.press('Backspace');
  await expect.poll(isAt(first)).toBe(true);
  await page.keyboard.press('Shift+Backspace');
  await expect.poll(isAt(top)).toBe(true);
  await page.keyboard.press('Shift+Backspace');
  await expect(page.getByRole('status')).toHaveText('No view to go on to');
});

test.describe('on a Mac', () => {
  test.use({ fresh: true });

  test('Control and a click open the menu, Command removes from the selection', async ({
    page,
  }) => {
    await page.addInitScript(() => {
      Object.defineProperty(Navigator.prototype, 'platform', { value: 'MacIntel' });
    });
    await openGrid(page, 4);
    await page.keyboard.press('b');
    await page.keyboard.press('1');
    const at = await screenOf(page, 12);
    await page.mouse.click(...at);
    await expect.poll(async () => (await state(page)).selection.vertices).toEqual([12]);
    await page.keyboard.down('Control');
    await page.mouse.click(...at);
    await page.keyboard.up('Control');
    await expect(page.getByRole('menu', { name: 'What is here' })).toBeVisible();
    await page.keyboard.press('Escape');
    expect((await state(page)).selection.vertices).toEqual([12]);
    await page.keyboard.down('Meta');
    await page.mouse.click(...at);
    await page.keyboard.up('Meta');
    await expect.poll(async () => (await state(page)).selection.vertices).toEqual([]);
  });
});
