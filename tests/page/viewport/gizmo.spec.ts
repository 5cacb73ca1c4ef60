// Handles: the gizmo, making and moving in one drag, numbers, keys, and the menu.

import type { Page } from '@playwright/test';
import { addConstraint, hidePanels, openGrid, showStep } from '../actions.ts';
import {
  everything,
  expect,
  screenOf,
  state,
  test,
  waitForState,
  type PageState,
} from '../support.ts';

test.use({ sameDocument: true });

const N = 6;
const VERTICES = (N + 1) ** 2;
const MIDDLE = (VERTICES - 1) / 2;

test.beforeEach(({ page }) => openGrid(page, N));

/** Selects vertices by clicks and makes them handles. */
async function makeHandles(page: Page, vertices: number[]) {
  await hidePanels(page);
  for (const vertex of vertices) {
    if (vertex !== vertices[0]) await page.keyboard.down('Shift');
    await page.mouse.click(...(await screenOf(page, vertex)));
    await page.keyboard.up('Shift');
  }
  await waitForState(
    page,
    (now, count) => now.selection.vertices.length === count,
    vertices.length,
  );
  await page.keyboard.press('h');
  return waitForState(page, (now, count) => now.handles.length === count, vertices.length);
}

/** The position of a part of the gizmo. */
async function partOf(page: Page, part: string): Promise<[number, number]> {
  let at: [number, number] | null = null;
  const look = async () => (at = await page.evaluate((name) => window.shapeUp.gizmo(name), part));
  await expect.poll(look, { message: `${part} of the gizmo is there` }).not.toBeNull();
  return at ?? [NaN, NaN];
}

/** Drags a part of the gizmo without releasing the button. */
async function pull(page: Page, part: string, [dx, dy]: number[]) {
  const [x, y] = await partOf(page, part);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx, y + dy, { steps: 4 });
}

/** The ways that the handles have gone. */
const ways = (before: PageState, after: PageState) =>
  after.handles.map(({ target }, i) =>
    target.map((value, axis) => value - before.handles[i].target[axis]),
  );
const undoButton = (page: Page) => page.getByRole('button', { name: 'Undo' });

test('an arrow moves all selected handles along its axis and shows the distance', async ({
  page,
}) => {
  await addConstraint(page, 'Plane', 'each face');
  const before = await makeHandles(page, [MIDDLE, MIDDLE + 1]);
  await pull(page, 'z', [0, -40]);
  await expect(page.getByText(/^z \+\d+(\.\d+)?/)).toBeVisible();
  await page.mouse.up();
  await expect(page.getByText(/^z \+\d/)).toBeHidden();
  const [first, second] = ways(before, await state(page));
  expect(first[2]).toBeGreaterThan(0);
  expect(first.slice(0, 2)).toEqual([0, 0]);
  for (const axis of [0, 1, 2]) expect(second[axis]).toBeCloseTo(first[axis], 12);
  await expect(undoButton(page)).toHaveAttribute('title', /Move 2 handles/);
});

test('a square moves the handle in its plane, and Escape restores it exactly', async ({ page }) => {
  await addConstraint(page, 'Plane', 'each face');
  const before = await makeHandles(page, [MIDDLE]);
  const exact = await everything(page);
  await pull(page, 'xy', [30, 12]);
  await expect.poll(async () => ways(before, await state(page))[0][0]).not.toBe(0);
  const [[x, y, z]] = ways(before, await state(page));
  expect(Math.hypot(x, y)).toBeGreaterThan(0);
  expect(z).toBe(0);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await expect.poll(() => everything(page)).toEqual(exact);
  await expect(undoButton(page)).toHaveAttribute('title', /Make 1 handle/);
});

test('the gizmo is shown for selected handles only, and can be switched off', async ({ page }) => {
  const gizmo = () => page.evaluate(() => window.shapeUp.gizmo('z'));
  await hidePanels(page);
  await page.mouse.click(...(await screenOf(page, MIDDLE)));
  await waitForState(page, (now) => now.selection.vertices.length === 1);
  expect(await gizmo()).toBeNull();
  await page.keyboard.press('h');
  await waitForState(page, (now) => now.handles.length === 1);
  await partOf(page, 'z');
  await showStep(page, 'Check');
  await page.getByRole('checkbox', { name: 'Arrows at handles' }).uncheck();
  await expect.poll(gizmo).toBeNull();
  await page.getByRole('checkbox', { name: 'Arrows at handles' }).check();
  await hidePanels(page);
  await partOf(page, 'z');
  await page.getByRole('application', { name: '3D view' }).focus();
  await page.keyboard.press('Escape');
  await expect.poll(gizmo).toBeNull();
});

test('Alt and a drag make a handle and move it in one undo step', async ({ page }) => {
  await addConstraint(page, 'Plane', 'each face');
  await hidePanels(page);
  const before = await everything(page);
  const [x, y] = await screenOf(page, MIDDLE);
  const press = async () => {
    await page.keyboard.down('Alt');
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x, y - 30, { steps: 4 });
    await waitForState(page, (now) => now.handles.length === 1);
    await page.mouse.move(x, y - 50, { steps: 4 });
    await expect.poll(async () => (await everything(page)).positions).not.toEqual(before.positions);
  };
  await press();
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await page.keyboard.up('Alt');
  await expect.poll(() => everything(page)).toEqual(before);
  await expect(undoButton(page)).toHaveAttribute('title', /Add plane/);

  await press();
  await page.mouse.up();
  await page.keyboard.up('Alt');
  await expect(undoButton(page)).toHaveAttribute('title', /Make and move handle/);
  const [{ vertex, target }] = (await state(page)).handles;
  expect(vertex).toBe(MIDDLE);
  expect(target).not.toEqual(before.positions.slice(3 * MIDDLE, 3 * MIDDLE + 3));
  await page.keyboard.press('Control+z');
  await expect.poll(() => everything(page)).toEqual(before);
});

test('keys move a handle at its height or along an axis; numbers and Fixed work too', async ({
  page,
}) => {
  const before = await makeHandles(page, [MIDDLE]);
  await page.getByRole('application', { name: '3D view' }).focus();
  await page.keyboard.press('Enter');
  await page.keyboard.press('Shift+ArrowRight');
  await waitForState(page, (now, x) => now.handles[0].target[0] !== x, before.handles[0].target[0]);
  const [level] = ways(before, await state(page));
  expect(level[2]).toBe(0);
  await page.keyboard.press('z');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Enter');
  const [upwards] = ways(before, await state(page));
  expect(upwards.slice(0, 2)).toEqual([0, 0]);
  expect(upwards[2]).toBeGreaterThan(0);

  await showStep(page, 'Shape');
  const target = page.getByRole('spinbutton', { name: 'Target z' });
  await target.fill('7.5');
  await target.press('Enter');
  await waitForState(page, (now) => now.handles[0].target[2] === 7.5);
  await page.getByRole('button', { name: 'Fixed' }).click();
  await waitForState(page, (now) => now.handles[0].fixed);
});

test('a handle that is removed while keys move it is not moved any more', async ({ page }) => {
  // Its label counted on, Undo was disabled, and the status said "Handle moved".
  await makeHandles(page, [MIDDLE]);
  await page.getByRole('application', { name: '3D view' }).focus();
  await page.keyboard.press('Enter');
  await page.keyboard.press('ArrowRight');
  await expect(page.locator('#moved')).toBeVisible();
  await page.keyboard.press('Shift+H');
  await waitForState(page, (now) => now.handles.length === 0);
  await expect(page.locator('#moved')).toBeHidden();
  await expect(page.getByRole('button', { name: 'Undo' })).toBeEnabled();
  await expect(page.getByRole('status')).toHaveText('1 handle removed');
});

test('Ctrl moves a dragged handle vertically, Shift horizontally', async ({ page }) => {
  const before = await makeHandles(page, [MIDDLE]);
  const [x, y] = await screenOf(page, MIDDLE);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.keyboard.down('Control');
  await page.mouse.move(x + 20, y - 40, { steps: 4 });
  await expect.poll(async () => ways(before, await state(page))[0][2]).toBeGreaterThan(0);
  await expect(page.locator('#moved')).toHaveText(/ m$/);
  expect(ways(before, await state(page))[0].slice(0, 2)).toEqual([0, 0]);
  await page.keyboard.up('Control');
  await page.keyboard.down('Shift');
  await page.mouse.move(x + 24, y - 30, { steps: 2 });
  await expect.poll(async () => ways(before, await state(page))[0][2]).toBe(0);
  await page.keyboard.up('Shift');
  // Z, too, keeps it to its vertical, until it is pressed again.
  await page.keyboard.press('z');
  await page.mouse.move(x + 20, y - 40, { steps: 2 });
  await expect.poll(async () => ways(before, await state(page))[0][2]).toBeGreaterThan(0);
  expect(ways(before, await state(page))[0].slice(0, 2)).toEqual([0, 0]);
  await page.mouse.up();
});

test('a right click and the menu key show the commands available here', async ({ page }) => {
  await hidePanels(page);
  const menu = page.getByRole('menu', { name: 'What is here' });
  await page.mouse.click(...(await screenOf(page, MIDDLE)), { button: 'right' });
  await expect(menu).toBeVisible();
  await expect(
    menu
      .getByRole('group', { name: 'Constraints' })
      .getByRole('menuitem', { name: 'Add constraint' }),
  ).toBeVisible();
  await menu
    .getByRole('group', { name: 'Handles' })
    .getByRole('menuitem', { name: 'Make handle' })
    .click();
  await expect(menu).toBeHidden();
  const made = await waitForState(page, (now) => now.handles.length === 1);
  expect(made.handles[0].vertex).toBe(MIDDLE);

  await page.getByRole('application', { name: '3D view' }).focus();
  await page.keyboard.press('Shift+F10');
  await expect(menu.getByRole('menuitem').first()).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(menu).toBeHidden();
  await page.keyboard.press('Shift+F10');
  await menu.getByRole('menuitem', { name: 'Remove handle' }).press('Enter');
  await waitForState(page, (now) => now.handles.length === 0);
});
