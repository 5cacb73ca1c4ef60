// Constraints, handles, runs and undo.

import type { Page } from '@playwright/test';
import { addConstraint, hidePanels, openGrid, runToTheEnd, showStep, tool } from '../actions.ts';
import {
  dragVertex,
  expect,
  known,
  positionOf,
  screenOf,
  state,
  test,
  waitForState,
} from '../support.ts';

test.use({ sameDocument: true });

const N = 6;
const VERTICES = (N + 1) ** 2;
const MIDDLE = (VERTICES - 1) / 2;

test.beforeEach(({ page }) => openGrid(page, N));

/** Draws a box around vertices with the Select tool, from left to right. */
async function selectBox(page: Page, vertices: number[]) {
  await hidePanels(page);
  await page.getByRole('button', { name: 'Select', exact: true }).click();
  const at = await Promise.all(vertices.map((vertex) => screenOf(page, vertex)));
  const [xs, ys] = [at.map(([x]) => x), at.map(([, y]) => y)];
  await page.mouse.move(Math.min(...xs) - 8, Math.min(...ys) - 8);
  await page.mouse.down();
  await page.mouse.move(Math.max(...xs) + 8, Math.max(...ys) + 8, { steps: 4 });
  await page.mouse.up();
}

test('circles on all faces and a sphere on a box selection: the errors fall', async ({ page }) => {
  await addConstraint(page, 'Circle', 'each face');
  const around = [MIDDLE, MIDDLE - 1, MIDDLE + 1, MIDDLE - N - 1, MIDDLE + N + 1];
  await selectBox(page, around);
  const { selection } = await state(page);
  for (const vertex of around) expect(selection.vertices).toContain(vertex);
  await addConstraint(page, 'Sphere', 'whole selection together');

  const before = await state(page);
  expect(before.constraints).toEqual({ circle: N * N, sphere: 1 });
  const after = await runToTheEnd(page);
  expect(after.circularity?.max_distance).toBeLessThan(
    0.1 * known(before.circularity).max_distance,
  );
  expect(after.energy?.shape).toBeLessThan(known(before.energy).shape);
  await showStep(page, 'Shape');
  await expect(page.getByRole('list', { name: 'Constraints' }).getByRole('listitem')).toHaveCount(
    2,
  );
});

test('a constraint is added on each selected face', async ({ page }) => {
  await page.keyboard.press('3');
  const [x0, y0] = await screenOf(page, MIDDLE);
  const [x1, y1] = await screenOf(page, MIDDLE + N + 2);
  await page.mouse.click((x0 + x1) / 2, (y0 + y1) / 2);
  await waitForState(page, (now) => now.selection.faces.length === 1);
  await addConstraint(page, 'Plane', 'each selected face');
  expect((await state(page)).constraints).toEqual({ plane: 1 });
});

test('a constraint is weighted, switched off and removed', async ({ page }) => {
  await addConstraint(page, 'Plane', 'each face');
  const row = page.getByRole('list', { name: 'Constraints' }).getByRole('listitem');
  const weight = row.getByRole('spinbutton');
  await weight.fill('7');
  await weight.press('Enter');
  const first = () => page.evaluate(() => window.shapeUp.scene().constraints[0]);
  await expect.poll(async () => (await first()).weight).toBe(7);
  await row.getByRole('switch').uncheck();
  await waitForState(page, (now) => now.constraints.plane === undefined);
  await row.getByRole('button', { name: /parameters/ }).click();
  await row.getByRole('button', { name: /remove/ }).click();
  await expect(row).toHaveCount(0);
});

test('a double-click makes a handle, a drag moves it, and the mesh follows', async ({ page }) => {
  await addConstraint(page, 'Plane', 'each face');
  await hidePanels(page);
  await page.mouse.dblclick(...(await screenOf(page, MIDDLE)));
  const made = await waitForState(page, (now) => now.handles.length === 1);
  expect(made.handles[0].vertex).toBe(MIDDLE);

  const before = await positionOf(page, MIDDLE);
  const neighbour = await positionOf(page, MIDDLE + 1);
  await dragVertex(page, MIDDLE, [0, -60]);
  const lifted = await waitForState(
    page,
    (now, z) => now.iteration > 0 && now.handles[0].target[2] > z,
    before[2],
  );
  const [{ target }] = lifted.handles;
  await expect
    .poll(async () => (await positionOf(page, MIDDLE))[2])
    .toBeGreaterThan(before[2] + 0.5 * (target[2] - before[2]));
  expect((await positionOf(page, MIDDLE + 1))[2]).toBeGreaterThan(neighbour[2]);
  // The solver was paused before the drag, and is paused again.
  expect((await state(page)).running).toBe(false);

  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(async () => (await positionOf(page, MIDDLE))[2]).toBeCloseTo(before[2], 9);
  expect((await state(page)).handles[0].target[2]).toBeCloseTo(before[2], 9);
  await page.getByRole('button', { name: 'Redo' }).click();
  await waitForState(page, (now, z) => now.handles[0].target[2] === z, target[2]);
});

test('Escape puts a dragged handle back', async ({ page }) => {
  await page.mouse.click(...(await screenOf(page, MIDDLE)));
  await page.keyboard.press('h');
  const made = await waitForState(page, (now) => now.handles.length === 1);
  const [x, y] = await screenOf(page, MIDDLE);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y - 40, { steps: 4 });
  await expect
    .poll(async () => (await state(page)).handles[0].target)
    .not.toEqual(made.handles[0].target);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await expect
    .poll(async () => (await state(page)).handles[0].target)
    .toEqual(made.handles[0].target);
});

test('every edit is one undo step', async ({ page }) => {
  const undo = page.getByRole('button', { name: 'Undo' });
  await expect(undo).toBeDisabled();
  await addConstraint(page, 'Plane', 'each face');
  await hidePanels(page);
  await page.mouse.click(...(await screenOf(page, MIDDLE)));
  await page.keyboard.press('h');
  await waitForState(page, (now) => now.handles.length === 1);
  await undo.click();
  await waitForState(page, (now) => now.handles.length === 0 && now.constraints.plane === 36);
  await undo.click();
  await waitForState(page, (now) => now.constraints.plane === undefined);
  await expect(undo).toBeDisabled();
  await page.keyboard.press('Control+y');
  await waitForState(page, (now) => now.constraints.plane === 36);
});

test('run, pause, step and reset work by keys, and changing a weight is an edit', async ({
  page,
}) => {
  await addConstraint(page, 'Plane', 'each face');
  await hidePanels(page);
  await page.getByRole('application', { name: '3D view' }).focus();
  await page.keyboard.press('.');
  await waitForState(page, (now) => now.iteration === 1 && !now.running);
  await page.keyboard.press(' ');
  await waitForState(page, (now) => now.iteration > 1 && now.converged);
  await page.keyboard.press('Shift+R');
  await waitForState(page, (now) => now.iteration === 0);

  // Changing the weights of the energies is an edit too.
  await showStep(page, 'Shape');
  const weight = page.getByRole('spinbutton', { name: 'Close weight' });
  await weight.fill('12');
  await weight.press('Enter');
  const close = () => page.evaluate(() => window.shapeUp.scene().weights?.close);
  await expect.poll(close).toBe(12);
  await tool(page, 'Undo');
  await expect(weight).not.toHaveValue('12');
});
