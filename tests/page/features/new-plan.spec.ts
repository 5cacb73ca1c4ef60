// From a drawn plan to a roof of exactly circular panels.

import type { Locator, Page } from '@playwright/test';
import {
  boxOf,
  expect,
  openPage,
  sceneOf,
  state,
  test,
  waitForState,
  type PageState,
} from '../support.ts';

test.use({ sameDocument: true });

async function openPlan(page: Page) {
  await openPage(page);
  await page.getByRole('button', { name: 'Examples' }).click();
  await page.getByRole('menuitem', { name: 'New mesh' }).click();
  const dialog = page.getByRole('dialog', { name: 'New mesh' });
  await dialog.getByLabel('Shape').selectOption({ label: 'From a plan' });
  await waitForState(page, (now) => now.faces === 160);
  return dialog;
}

const point = (dialog: Locator, number: number) =>
  dialog.getByRole('button', { name: new RegExp(`^Point ${number} of the outline`) });

/** Presses in the drawing at a position given as fractions of its size. */
async function pressAt(page: Page, dialog: Locator, [x, y]: number[]) {
  const box = await boxOf(dialog.getByRole('group', { name: 'Plan' }));
  await page.mouse.move(box.x + x * box.width, box.y + y * box.height);
  await page.mouse.down();
  await page.mouse.up();
}

test('a drawn plan becomes a roof of exactly circular panels', async ({ page }) => {
  const dialog = await openPlan(page);

  // A corner is dragged outward, snapping to the grid of the drawing; the roof follows.
  const corner = await boxOf(point(dialog, 3));
  const at: [number, number] = [corner.x + corner.width / 2, corner.y + corner.height / 2];
  await page.mouse.move(...at);
  await page.mouse.down();
  await page.mouse.move(at[0] + 20, at[1] - 20, { steps: 4 });
  await page.mouse.up();
  const [x, y] = [dialog.getByLabel('x', { exact: true }), dialog.getByLabel('y', { exact: true })];
  expect(Number(await x.inputValue())).toBeGreaterThan(20);
  expect(Number(await x.inputValue()) % 0.5).toBe(0);
  const farthest = async () =>
    Math.max(...(await sceneOf(page)).mesh.positions.map((vertex: number[]) => vertex[0]));
  await expect.poll(farthest).toBeCloseTo(Number(await x.inputValue()), 9);

  // Typed lengths: the side from point 2 is 14 m long, an arc rises by 1.5 m.
  await x.fill('20');
  await x.press('Enter');
  await y.fill('12');
  await y.press('Enter');
  await point(dialog, 2).focus();
  await dialog.getByLabel('Side').fill('14');
  await dialog.getByLabel('Side').press('Enter');
  await expect(point(dialog, 3)).toHaveAccessibleName(/20, 14 m/);
  await dialog.getByLabel('Rise').fill('1.5');
  await dialog.getByLabel('Rise').press('Enter');
  await expect.poll(farthest).toBeCloseTo(21.5, 1);
  await dialog.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(farthest).toBeCloseTo(20, 9);

  await dialog.getByRole('button', { name: 'Create mesh' }).click();
  await expect(dialog).toBeHidden();
  await page.getByRole('button', { name: 'Make panels circular', exact: true }).click();
  await waitForState(page, (now) => !now.running && now.exact?.met);
  await page.getByRole('button', { name: 'Make exact' }).first().click();
  const isExact = (now: PageState) =>
    !now.running && now.exact?.met && now.exact.max_distance < 1e-9;
  const done = await waitForState(page, isExact);
  expect(done.constraints.circle).toBe(done.faces);
  // The roof stands where it was drawn.
  expect((await state(page)).handles.map(({ fixed }) => fixed)).toEqual([true, true, true, true]);
});

test('a number that is typed for a point stays with it, and Undo ends a drag', async ({ page }) => {
  const dialog = await openPlan(page);
  const [x, y] = [dialog.getByLabel('x', { exact: true }), dialog.getByLabel('y', { exact: true })];
  await point(dialog, 1).focus();
  const [first, low] = await Promise.all(
    [x, y].map(async (field) => Number(await field.inputValue())),
  );
  const middle = async (of: Locator) => {
    const { x, y, width, height } = await boxOf(of);
    return [x + width / 2, y + height / 2] as const;
  };
  const second = await point(dialog, 2).getAttribute('aria-label');
  await x.fill(String(first + 1));
  // The second point was moved there in its place.
  await page.mouse.click(...(await middle(point(dialog, 2))));
  await expect(point(dialog, 1)).toHaveAccessibleName(new RegExp(`, ${first + 1}, ${low} `));
  expect(await point(dialog, 2).getAttribute('aria-label')).toBe(second);
  const [left, top] = await middle(point(dialog, 2));
  await page.mouse.move(left, top);
  await page.mouse.down();
  await page.mouse.move(left + 20, top + 20, { steps: 3 });
  await page.keyboard.press('Control+z');
  await page.mouse.move(left + 40, top + 40, { steps: 3 });
  await page.mouse.up();
  expect(await point(dialog, 2).getAttribute('aria-label')).toBe(second);
});

test('an outline and a hole are drawn, panels are cut to them, and mistakes are shown', async ({
  page,
}) => {
  const dialog = await openPlan(page);
  await dialog.getByRole('button', { name: 'Draw the outline' }).click();
  const outline = [
    [0.2, 0.8],
    [0.85, 0.8],
    [0.85, 0.45],
    [0.5, 0.45],
    [0.5, 0.15],
    [0.2, 0.15],
  ];
  for (const place of [...outline, outline[0]]) await pressAt(page, dialog, place);
  await expect(dialog.getByLabel('Panels')).toHaveValue('cut');
  await expect(point(dialog, 6)).toBeVisible();
  await waitForState(page, (now) => now.faces !== 160);
  const whole = await state(page);
  await expect(dialog.getByRole('button', { name: 'Create mesh' })).toBeEnabled();

  await dialog.getByRole('button', { name: 'Draw a hole' }).click();
  const hole = [
    [0.28, 0.58],
    [0.38, 0.58],
    [0.38, 0.72],
    [0.28, 0.72],
  ];
  for (const place of [...hole, hole[0]]) await pressAt(page, dialog, place);
  await expect(dialog.getByRole('heading', { name: 'Point 1 of hole 1' })).toBeVisible();
  await waitForState(page, (now, faces) => now.faces < faces, whole.faces);

  // Moves a point past the opposite side, so that sides cross.
  await point(dialog, 1).focus();
  await dialog.getByLabel('y', { exact: true }).fill('100');
  await dialog.getByLabel('y', { exact: true }).press('Enter');
  await expect(
    dialog.getByText(/side \d of the outline and side \d of the outline cross or touch/),
  ).toBeVisible();
  await expect(dialog.getByRole('button', { name: 'Create mesh' })).toBeDisabled();
  await dialog.getByRole('button', { name: 'Undo' }).click();
  await expect(dialog.getByRole('button', { name: 'Create mesh' })).toBeEnabled();

  // Esc ends the drawing, not the dialog.
  await dialog.getByRole('button', { name: 'Draw the outline' }).click();
  await pressAt(page, dialog, [0.5, 0.5]);
  await page.keyboard.press('Escape');
  await expect(dialog).toBeVisible();
  await expect(point(dialog, 6)).toBeVisible();
});

test('a second finger on the plan has no part in the drag of a point', async ({ page }) => {
  const dialog = await openPlan(page);
  const { x, y, width, height } = await boxOf(point(dialog, 3));
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 20, y + height / 2, { steps: 2 });
  const name = await point(dialog, 3).getAttribute('aria-label');
  const plan = dialog.getByRole('group', { name: 'Plan' });
  for (const type of ['pointermove', 'pointerup'])
    await plan.dispatchEvent(type, { pointerId: 7, clientX: 9, clientY: 9, bubbles: true });
  await expect(point(dialog, 3)).toHaveAttribute('aria-label', name ?? '');
  await page.mouse.move(x + width / 2 + 40, y + height / 2, { steps: 2 });
  await expect(point(dialog, 3)).not.toHaveAttribute('aria-label', name ?? '');
  await page.mouse.up();
});

test('points are moved, added and removed by keys, and a number typed last is in the mesh', async ({
  page,
}) => {
  const dialog = await openPlan(page);
  await point(dialog, 2).focus();
  await page.keyboard.press('ArrowRight');
  await expect(point(dialog, 2)).toHaveAccessibleName('Point 2 of the outline, 22, 0 m, corner');
  // A typed size is an undo step of its own.
  await dialog.getByLabel('Height').fill('6.5');
  await dialog.getByRole('button', { name: 'Undo' }).click();
  await expect(dialog.getByLabel('Height')).toHaveValue('5');
  await expect(point(dialog, 2)).toHaveAccessibleName('Point 2 of the outline, 22, 0 m, corner');
  await point(dialog, 2).focus();
  await page.keyboard.press('Control+z');
  await expect(point(dialog, 2)).toHaveAccessibleName('Point 2 of the outline, 20, 0 m, corner');
  await dialog.getByRole('button', { name: 'Add a point' }).click();
  await expect(point(dialog, 3)).toHaveAccessibleName('Point 3 of the outline, 20, 6 m');
  await expect(point(dialog, 3)).toBeFocused();
  await page.keyboard.press('Delete');
  await expect(point(dialog, 5)).toHaveCount(0);

  await expect(point(dialog, 3)).toHaveAccessibleName('Point 3 of the outline, 20, 12 m, corner');
  // Typed: `fill` reports the number at once.
  await dialog.getByLabel('x', { exact: true }).press('Control+A');
  await page.keyboard.type('24');
  await dialog.getByRole('button', { name: 'Create mesh' }).click();
  await expect(dialog).toBeHidden();
  const { mesh } = await sceneOf(page);
  expect(Math.max(...mesh.positions.map(([x]: number[]) => x))).toBe(24);
});

test('crossing sides are marked in the drawing, and the plan is there the next time', async ({
  page,
}) => {
  const dialog = await openPlan(page);
  const crossing = dialog.getByRole('group', { name: 'Plan' }).locator('.crossing');
  await expect(crossing).toHaveCount(0);
  await point(dialog, 3).focus();
  const [x, y] = [dialog.getByLabel('x', { exact: true }), dialog.getByLabel('y', { exact: true })];
  await x.fill('-6');
  await x.press('Enter');
  await y.fill('6');
  await y.press('Enter');
  await expect(dialog.getByText(/cross or touch/)).toBeVisible();
  await expect(crossing).toHaveCount(2);
  await expect(dialog.getByRole('button', { name: 'Create mesh' })).toBeDisabled();
  await x.fill('26');
  await x.press('Enter');
  await expect(crossing).toHaveCount(0);
  await dialog.getByRole('button', { name: 'Create mesh' }).click();
  await expect(dialog).toBeHidden();
  // The next time, in another unit, the dialog shows the plan as it was left.
  await page.getByRole('button', { name: 'Examples' }).click();
  await page.getByRole('menuitem', { name: 'New mesh' }).click();
  await dialog.getByLabel('Unit').selectOption('mm');
  await dialog.getByLabel('Shape').selectOption({ label: 'From a plan' });
  await expect(point(dialog, 3)).toHaveAccessibleName(/26000, 6000 mm/);
  await dialog.getByRole('button', { name: 'Start over' }).click();
  await expect(point(dialog, 3)).toHaveAccessibleName(/20000, 12000 mm/);
  await dialog.getByRole('button', { name: 'Undo' }).click();
  await expect(point(dialog, 3)).toHaveAccessibleName(/26000, 6000 mm/);
});

test('every point is reached by keys, and a loop that was drawn has the focus', async ({
  page,
}) => {
  const dialog = await openPlan(page);
  // Only the selected point was reached, and nothing selected another one.
  await point(dialog, 1).focus();
  await page.keyboard.press('Tab');
  await expect(point(dialog, 2)).toBeFocused();
  await expect(dialog.getByRole('heading', { name: 'Point 2 of the outline' })).toBeVisible();
  await page.keyboard.press('ArrowRight');
  await expect(point(dialog, 2)).toHaveAccessibleName('Point 2 of the outline, 22, 0 m, corner');
  // Keys were without effect after drawing.
  await dialog.getByRole('button', { name: 'Draw the outline' }).click();
  const corners = [
    [0.2, 0.8],
    [0.8, 0.8],
    [0.8, 0.2],
  ];
  for (const place of corners) await pressAt(page, dialog, place);
  await page.keyboard.press('Enter');
  await expect(point(dialog, 1)).toBeFocused();
});

test('a plan and sizes are there again after a look at another shape, also in another unit', async ({
  page,
}) => {
  // Each form forgot what was in it when another shape was chosen; a unit dropped all undo steps.
  const dialog = await openPlan(page);
  const shape = dialog.getByLabel('Shape');
  await point(dialog, 2).focus();
  await page.keyboard.press('ArrowRight');
  await shape.selectOption({ label: 'Dome' });
  const size = dialog.getByRole('spinbutton').first();
  await size.fill('9');
  await shape.selectOption({ label: 'From a plan' });
  await expect(point(dialog, 2)).toHaveAccessibleName('Point 2 of the outline, 22, 0 m, corner');
  await dialog.getByLabel('Unit').selectOption('mm');
  await expect(point(dialog, 2)).toHaveAccessibleName(/22000, 0 mm/);
  await dialog.getByRole('button', { name: 'Undo' }).click();
  await expect(point(dialog, 2)).toHaveAccessibleName(/20000, 0 mm/);
  await shape.selectOption({ label: 'Dome' });
  await expect(size).toHaveValue('9000');
});

test('a length that the plan cannot have is refused with the reason, and an angle need not be whole', async ({
  page,
}) => {
  // It went back without a word; 22.5 was refused.
  const dialog = await openPlan(page);
  await point(dialog, 2).focus();
  const wrong = async (name: string, text: string) => {
    const field = dialog.getByLabel(name);
    await field.fill(text);
    return field.evaluate((input: HTMLInputElement) => input.validationMessage);
  };
  expect(await wrong('Side', '0')).toBe('Expected a number above 0.');
  expect(await wrong('Rise', '1000')).toMatch(/^Expected at most/);
  await dialog.getByLabel('Panels').selectOption({ label: 'A grid, cut to fit' });
  expect(await wrong('Turned by', '22.5')).toBe('');
});
