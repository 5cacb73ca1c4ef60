// Selecting as a user does: by click, box, lasso, brush and menu, with the status announced.

import type { Page } from '@playwright/test';
import { hidePanels, openText } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import {
  boxOf,
  expect,
  middleOf,
  openPage,
  screenOf,
  settled,
  state,
  test,
  waitForState,
} from '../support.ts';

test.use({ sameDocument: true });

const N = 6;
const SIDE = N + 1;
const VERTICES = SIDE ** 2;
/** The vertex in column x and row y. */
const vertex = (x: number, y: number) => y * SIDE + x;

test.beforeEach(async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), VERTICES);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
  await hidePanels(page);
});

const bar = (page: Page) => page.getByRole('toolbar', { name: 'Selection' });
const status = (page: Page) => page.getByRole('status');

/** The centre of the face whose lower left corner is in column x and row y. */
const faceAt = (page: Page, x: number, y: number) =>
  middleOf(page, [vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)]);

/** The numbers of selected vertices, edges and faces. */
async function counts(page: Page) {
  const { selection } = await state(page);
  return [selection.vertices.length, selection.edges.length, selection.faces.length];
}

async function drag(page: Page, points: [number, number][], modifier?: string) {
  const [first, ...others] = points;
  if (modifier) await page.keyboard.down(modifier);
  await page.mouse.move(...first);
  await page.mouse.down();
  for (const point of others) await page.mouse.move(...point, { steps: 4 });
  await page.mouse.up();
  if (modifier) await page.keyboard.up(modifier);
}

/** Chooses an item of the "Select by" menu. */
async function selectBy(page: Page, item: string | RegExp) {
  await bar(page)
    .getByRole('button', { name: /select by/i })
    .click();
  await page.getByRole('dialog', { name: 'Select' }).getByRole('button', { name: item }).click();
}

test('clicks select vertices, edges and faces; Shift adds, Control removes', async ({ page }) => {
  await page.keyboard.press('2');
  const edge = (x: number, y: number) => middleOf(page, [vertex(x, y), vertex(x + 1, y)]);
  await page.mouse.click(...(await edge(2, 3)));
  await expect(status(page)).toHaveText('1 edge selected');
  await page.keyboard.down('Shift');
  await page.mouse.click(...(await edge(3, 3)));
  await page.keyboard.up('Shift');
  await expect(status(page)).toHaveText('2 edges selected');
  await page.keyboard.down('Control');
  await page.mouse.click(...(await edge(2, 3)));
  await page.keyboard.up('Control');
  await expect(status(page)).toHaveText('1 edge selected');

  await page.keyboard.press('3');
  await page.mouse.click(...(await faceAt(page, 2, 2)));
  await expect(status(page)).toHaveText('1 face selected');
  expect((await state(page)).selection).toEqual({ vertices: [], edges: [], faces: [2 * N + 2] });
  await page.keyboard.press('1');
  await page.mouse.click(...(await screenOf(page, vertex(3, 3))));
  await expect(status(page)).toHaveText('1 vertex selected');
  await page.keyboard.press('Escape');
  await expect(status(page)).toHaveText('Nothing selected');

  // Digits work by key position: on a French keyboard the unshifted key of 2 prints é.
  await page.evaluate(() =>
    document.body.dispatchEvent(
      new KeyboardEvent('keydown', { key: 'é', code: 'Digit2', bubbles: true }),
    ),
  );
  await page.mouse.click(...(await edge(2, 3)));
  await expect.poll(() => counts(page)).toEqual([0, 1, 0]);
});

test('a box to the right selects what is inside, to the left also what it touches', async ({
  page,
}) => {
  await page.keyboard.press('b');
  await page.keyboard.press('3');
  // From the centre of one face to the centre of the next but one.
  const [from, to] = [await faceAt(page, 1, 3), await faceAt(page, 4, 3)];
  const [left, right] = from[0] < to[0] ? [from, to] : [to, from];
  const [a, b]: [number, number][] = [
    [left[0], Math.min(left[1], right[1]) - 2],
    [right[0], Math.max(left[1], right[1]) + 2],
  ];
  await drag(page, [a, b]);
  const window = (await counts(page))[2];
  await drag(page, [b, a]);
  const crossing = (await counts(page))[2];
  expect(crossing).toBeGreaterThan(Math.max(window, 3));
  // With "Touching" the direction does not matter.
  await page.getByRole('button', { name: 'Touching' }).click();
  await drag(page, [a, b]);
  expect((await counts(page))[2]).toBe(crossing);
});

test('a lasso selects what it encloses, and Escape restores the selection', async ({ page }) => {
  await page.keyboard.press('l');
  const ring = await Promise.all(
    [vertex(1, 1), vertex(5, 1), vertex(5, 5), vertex(1, 5)].map((one) => screenOf(page, one)),
  );
  const [x, y] = await screenOf(page, vertex(3, 3));
  // Slightly outside the ring of vertices.
  const around = ring.map(([u, v]): [number, number] => [u + 0.12 * (u - x), v + 0.12 * (v - y)]);
  await drag(page, [...around, around[0]]);
  await expect.poll(async () => (await counts(page))[0]).toBeGreaterThan(8);
  const { selection } = await state(page);
  expect(selection.vertices).toContain(vertex(3, 3));
  expect(selection.vertices).not.toContain(vertex(0, 0));

  await page.mouse.move(...around[0]);
  await page.mouse.down();
  await page.mouse.move(...around[1], { steps: 4 });
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await settled(page);
  expect((await state(page)).selection).toEqual(selection);
});

test('a brush selects what it touches, and can be made larger and smaller', async ({ page }) => {
  await page.keyboard.press('p');
  await page.keyboard.press('3');
  const radius = bar(page).getByRole('slider', { name: 'Brush radius' });
  await radius.fill('6');
  const way = [await faceAt(page, 1, 2), await faceAt(page, 4, 2)];
  await drag(page, way);
  const thin = (await state(page)).selection.faces;
  for (const x of [1, 2, 3, 4]) expect(thin).toContain(2 * N + x);
  await page.getByRole('application', { name: '3D view' }).focus();
  for (let press = 0; press < 9; press++) await page.keyboard.press(']');
  expect(Number(await radius.inputValue())).toBeGreaterThan(20);
  const before = Number(await radius.inputValue());
  await page.mouse.move(...way[0]);
  await page.keyboard.down('Alt');
  await page.mouse.wheel(0, -100);
  await expect.poll(async () => Number(await radius.inputValue())).toBeGreaterThan(before);
  await page.mouse.wheel(0, 100);
  await page.keyboard.up('Alt');
  await drag(page, way);
  const thick = (await state(page)).selection.faces;
  expect(thick.length).toBeGreaterThan(thin.length);
  // A stroke with Control deselects.
  await drag(page, way, 'Control');
  expect((await state(page)).selection.faces.length).toBeLessThan(thick.length);
  // A press without movement is a stroke too.
  await page.mouse.click(...(await faceAt(page, 5, 5)));
  expect((await state(page)).selection.faces).toContain(5 * N + 5);
});

test('Through also selects hidden elements', async ({ page }) => {
  // Two squares, one above the other.
  const square = (z: number) =>
    [
      [0, 0],
      [4, 0],
      [4, 4],
      [0, 4],
    ].map(([x, y]) => `v ${x} ${y} ${z}`);
  const text = [...square(0), ...square(1), 'f 1 2 3 4', 'f 5 6 7 8', ''].join('\n');
  await openText(page, 'floors.obj', text, 8);
  await hidePanels(page);
  await page.keyboard.press('b');
  await page.keyboard.press('3');
  const view = await boxOf(page.getByRole('application', { name: '3D view' }));
  const corners: [number, number][] = [
    [view.x + view.width - 4, view.y + view.height - 140],
    [view.x + 4, view.y + 120],
  ];
  await bar(page).getByRole('button', { name: 'Select through' }).click();
  await drag(page, corners);
  await expect(status(page)).toHaveText('2 faces selected');
  await expect(bar(page).getByRole('button', { name: 'Select through' })).toHaveAttribute(
    'aria-pressed',
    'true',
  );
});

test('a drag turns the model about the point pressed', async ({ page }) => {
  const [pressed, other] = [vertex(4, 3), vertex(1, 1)];
  const [x, y] = await screenOf(page, pressed);
  const before = await screenOf(page, other);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 10, { steps: 4 });
  await page.mouse.up();
  await expect.poll(() => screenOf(page, other)).not.toEqual(before);
  const after = await screenOf(page, pressed);
  expect(Math.hypot(after[0] - x, after[1] - y)).toBeLessThan(3);
});

test('a double-click selects a loop or a flat patch; keys grow, shrink, invert and select all', async ({
  page,
}) => {
  // Independent of the kind of element that a click selects.
  await page.keyboard.press('1');
  await page.mouse.dblclick(...(await middleOf(page, [vertex(2, 3), vertex(3, 3)])));
  await expect(status(page)).toHaveText(`${N} edges selected`);
  await page.keyboard.down('Shift');
  await page.mouse.dblclick(...(await middleOf(page, [vertex(2, 3), vertex(3, 3)])));
  await page.keyboard.up('Shift');
  await expect(status(page)).toHaveText(`${N + 1} edges selected`);
  // On the boundary a second double-click selects all of it, elsewhere the loop again.
  await page.mouse.dblclick(...(await middleOf(page, [vertex(2, 0), vertex(3, 0)])));
  await expect(status(page)).toHaveText(`${N} edges selected`);
  await page.mouse.dblclick(...(await middleOf(page, [vertex(3, 0), vertex(4, 0)])));
  await expect(status(page)).toHaveText(`${4 * N} edges selected`);
  // Not of another selection.
  await page.mouse.dblclick(...(await middleOf(page, [vertex(3, 0), vertex(4, 0)])));
  await expect(status(page)).toHaveText(`${N} edges selected`);
  await page.keyboard.press('Escape');
  await expect(status(page)).toHaveText('Nothing selected');
  await page.mouse.dblclick(...(await middleOf(page, [vertex(3, 0), vertex(4, 0)])));
  await expect(status(page)).toHaveText(`${N} edges selected`);
  for (let twice = 0; twice < 2; twice++) {
    await page.mouse.dblclick(...(await middleOf(page, [vertex(2, 3), vertex(3, 3)])));
    await expect(status(page)).toHaveText(`${N} edges selected`);
  }
  // Alt and a click select the loop, too.
  await page.keyboard.down('Alt');
  await page.mouse.click(...(await middleOf(page, [vertex(3, 2), vertex(3, 3)])));
  await page.keyboard.up('Alt');
  await expect(status(page)).toHaveText(`${N} edges selected`);
  await page.mouse.dblclick(...(await faceAt(page, 3, 3)));
  await expect.poll(async () => (await counts(page))[2]).toBeGreaterThan(0);
  expect((await state(page)).selection.faces).toContain(3 * N + 3);

  // Keys grow, shrink, invert and select all.
  await page.mouse.click(...(await faceAt(page, 2, 2)));
  await expect(status(page)).toHaveText('1 face selected');
  await page.keyboard.press('+');
  await expect(status(page)).toHaveText('9 faces selected');
  await page.keyboard.press('Control+i');
  await expect(status(page)).toHaveText(`${N * N - 9} faces selected`);
  await page.keyboard.press('Control+i');
  await expect(status(page)).toHaveText('9 faces selected');
  await page.keyboard.press('-');
  await expect(status(page)).toHaveText('1 face selected');
  await page.keyboard.press('Control+a');
  await expect(status(page)).toHaveText(`${N * N} faces selected`);
});

test('the menu selects strips, rings, boundary loops and connected parts', async ({ page }) => {
  await page.keyboard.press('3');
  await page.mouse.click(...(await faceAt(page, 2, 2)));
  await selectBy(page, 'Face strip');
  await expect(status(page)).toHaveText(`${2 * N - 1} faces selected`);
  await selectBy(page, 'Faces along the boundary');
  await expect(status(page)).toHaveText(`${4 * N - 4} faces selected`);
  await selectBy(page, /^Connected/);
  await expect(status(page)).toHaveText(`${N * N} faces selected`);
  await selectBy(page, 'Convert to vertices');
  await expect(status(page)).toHaveText(`${VERTICES} vertices selected`);

  await page.keyboard.press('2');
  await page.mouse.click(...(await middleOf(page, [vertex(2, 3), vertex(3, 3)])));
  await selectBy(page, 'Edge ring');
  await expect(status(page)).toHaveText(`${N + 1} edges selected`);
});

test('elements are selected by valence, number of sides and error; wrong input is reported at its field', async ({
  page,
}) => {
  await page.keyboard.press('b');
  await selectBy(page, 'By number of edges…');
  const menu = page.getByRole('dialog', { name: 'Select' });
  await menu.getByRole('spinbutton', { name: 'Edges' }).fill('2');
  await menu.getByRole('button', { name: 'Find' }).click();
  await expect(status(page)).toHaveText('4 vertices selected');
  await expect(menu).toBeHidden();

  await page.keyboard.press('3');
  await selectBy(page, 'By error…');
  // Measures have their names, and what is typed has their unit.
  const measure = menu.getByRole('combobox', { name: 'Error: kind of value' });
  await measure.selectOption('Angle error');
  await expect(menu.getByText('°', { exact: true })).toBeVisible();
  await measure.selectOption('Planarity');
  await expect(menu.getByText('°', { exact: true })).toBeHidden();
  await menu.getByRole('spinbutton', { name: 'Above' }).fill('-1');
  await menu.getByRole('button', { name: 'Find' }).click();
  await expect(menu.getByRole('spinbutton', { name: 'Above' })).toHaveAttribute('aria-invalid');
  await menu.getByRole('spinbutton', { name: 'Above' }).fill('1000');
  await menu.getByRole('button', { name: 'Find' }).click();
  await expect(status(page)).toHaveText('By error: nothing found');
  await menu.getByRole('spinbutton', { name: 'Above' }).fill('0');
  await menu.getByRole('button', { name: 'Find' }).click();
  await expect.poll(async () => (await counts(page))[2]).toBeGreaterThan(9);

  await selectBy(page, 'By number of sides…');
  await menu.getByRole('button', { name: 'Subtract' }).click();
  await expect.poll(() => counts(page)).toEqual([0, 0, 0]);
});

test('faces are found by a curvature in the unit in which the legend has it', async ({ page }) => {
  // In a mesh in mm what was typed as 1/m was taken as 1/mm, so that nothing was found.
  await openText(page, 'wave.obj', `# units: mm\n${wavyGrid(6)}`, 49);
  for (const key of 'b3') await page.keyboard.press(key);
  await selectBy(page, 'By error…');
  const menu = page.getByRole('dialog', { name: 'Select' });
  const above = menu.getByRole('spinbutton', { name: 'Above' });
  await above.fill('1 m');
  await above.press('Tab');
  await expect(above).toHaveValue('1000');
  await menu.getByRole('combobox', { name: 'Error: kind of value' }).selectOption('Mean curvature');
  await expect(menu.getByText('1/m', { exact: true })).toBeVisible();
  await above.fill('10');
  await menu.getByRole('button', { name: 'Find' }).click();
  await expect.poll(async () => (await counts(page))[2]).toBeGreaterThan(9);
});

test('a length by which faces are found has the unit of the legend, and is not taken for another error', async ({
  page,
}) => {
  // In a mesh in m, 5 as in the legend was taken as 5 m; it stayed, as 5 of the unit of the next error.
  for (const key of 'b3') await page.keyboard.press(key);
  await selectBy(page, 'By error…');
  const menu = page.getByRole('dialog', { name: 'Select' });
  const above = menu.getByRole('spinbutton', { name: 'Above' });
  const measure = menu.getByRole('combobox', { name: 'Error: kind of value' });
  await measure.selectOption('Planarity');
  await expect(menu.getByText('mm', { exact: true })).toBeVisible();
  const tolerance = await above.inputValue();
  await above.fill('0.005 m');
  await above.press('Tab');
  await expect(above).toHaveValue('5');
  await measure.selectOption('Mean curvature');
  await expect(above).not.toHaveValue('5');
  // An error without a tolerance had the unit of the mesh.
  await measure.selectOption('Moved');
  await expect(menu.getByText('mm', { exact: true })).toBeVisible();
  await measure.selectOption('Planarity');
  await expect(above).toHaveValue(tolerance);
  await above.fill('1');
  await menu.getByRole('button', { name: 'Find' }).click();
  await expect.poll(async () => (await counts(page))[2]).toBeGreaterThan(9);
});

test('a selection is saved as a set in the scene, selected again, and removed', async ({
  page,
}) => {
  await page.keyboard.press('3');
  await page.mouse.click(...(await faceAt(page, 2, 2)));
  await page.keyboard.press('+');
  await expect(status(page)).toHaveText('9 faces selected');
  await selectBy(page, 'Save as a set…');
  await page.getByRole('textbox', { name: 'Name of the set' }).fill('skylight');
  await page.getByRole('button', { name: 'Save set' }).click();
  const sets = () => page.evaluate(() => Object.keys(window.shapeUp.scene().sets ?? {}));
  await expect.poll(sets).toEqual(['skylight']);
  await page.keyboard.press('Escape');
  await page.keyboard.press('b');
  await selectBy(page, /^skylight/);
  await expect(status(page)).toHaveText('9 faces selected');
  await selectBy(page, 'Remove set skylight');
  await expect.poll(sets).toEqual([]);
  await page.keyboard.press('Control+z');
  await expect.poll(sets).toEqual(['skylight']);
});
