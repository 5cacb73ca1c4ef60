// A mesh without a file: choosing a shape and its sizes with a live preview, keeping or cancelling
// it.

import type { Page } from '@playwright/test';
import { openText, showStep, tool } from '../actions.ts';
import { quadScene, wavyGrid } from '../meshes.ts';
import {
  boxOf,
  expect,
  hold,
  openPage,
  sceneOf,
  screenOf,
  state,
  test,
  waitForState,
} from '../support.ts';

test.use({ sameDocument: true });

async function openNewMesh(page: Page) {
  await page.getByRole('button', { name: 'Examples' }).click();
  await page.getByRole('menuitem', { name: 'New mesh' }).click();
  return page.getByRole('dialog', { name: 'New mesh' });
}

test('a new mesh follows its sizes, is kept, and is constrained', async ({ page }) => {
  await openPage(page);
  const dialog = await openNewMesh(page);
  await dialog.getByLabel('Shape').selectOption({ label: 'Hypar' });
  await waitForState(page, (now) => now.faces === 144);
  const first = dialog.getByRole('spinbutton').first();
  const length = Number(await first.inputValue());
  await dialog.getByLabel('Unit').selectOption('mm');
  await expect(first).toHaveValue(String(1000 * length));
  await first.fill('-1');
  await expect(dialog.getByRole('button', { name: 'Create mesh' })).toBeDisabled();
  await first.fill(String(2000 * length));
  await expect(dialog.getByText(/faces, .* vertices\./)).toBeVisible();
  await dialog.getByRole('button', { name: 'Create mesh' }).click();
  await expect(dialog).toBeHidden();
  const scene = await sceneOf(page);
  expect(scene.units).toBe('mm');
  const xs = scene.mesh.positions.map(([x]: number[]) => x);
  expect(Math.max(...xs) - Math.min(...xs)).toBeCloseTo(2000 * length, 6);
  await page.getByRole('button', { name: 'Make panels flat', exact: true }).click();
  await waitForState(page, (now) => !now.running && now.exact?.met);
});

test('another unit changes no size', async ({ page }) => {
  // What was typed was rounded, and the mesh grew by 4.4 mm.
  await openPage(page);
  const dialog = await openNewMesh(page);
  const first = dialog.getByRole('spinbutton').first();
  await first.fill('12.345678');
  const unit = dialog.getByLabel('Unit');
  await unit.selectOption('mm');
  await expect(first).toHaveValue('12345.7');
  const width = async () =>
    // It stands in the middle.
    2 * Math.max(...(await sceneOf(page)).mesh.positions.map(([x]: number[]) => x));
  await expect.poll(width).toBeCloseTo(12345.678, 6);
  await unit.selectOption('m');
  await expect(first).toHaveValue('12.345678');
});

test('a size that is taken out of its field is back in another unit', async ({ page }) => {
  await openPage(page);
  const dialog = await openNewMesh(page);
  const first = dialog.getByRole('spinbutton').first();
  const length = Number(await first.inputValue());
  await first.fill('');
  await expect(dialog.getByRole('button', { name: 'Create mesh' })).toBeDisabled();
  await dialog.getByLabel('Unit').selectOption('mm');
  // It was NaN.
  await expect(first).toHaveValue(String(1000 * length));
  await expect(dialog.getByText(/faces, .* vertices\./)).toBeVisible();
  await expect(dialog.getByRole('button', { name: 'Create mesh' })).toBeEnabled();
});

test('Cancel restores the previous model, an edited example as edited and under the same saved work', async ({
  page,
}) => {
  await openPage(page);
  const { vertices } = await state(page);
  const weight = page.getByLabel('Shape weight', { exact: true });
  await weight.fill('7');
  await weight.press('Enter');
  await expect.poll(async () => (await sceneOf(page)).weights.shape).toBe(7);
  // The camera and the plot were lost.
  await page.getByRole('application', { name: '3D view' }).focus();
  for (let k = 0; k < 5; k++) await page.keyboard.press('ArrowRight');
  await page.getByRole('tab', { name: 'Worst' }).click();
  const corner = await screenOf(page, 0);
  const before = await sceneOf(page);
  const own = () => page.evaluate(() => sessionStorage.getItem('shape-up.work'));
  const work = await own();
  const dialog = await openNewMesh(page);
  await waitForState(page, (now, count) => now.vertices !== count, vertices);
  await dialog.getByRole('button', { name: 'Cancel' }).click();
  await waitForState(page, (now, count) => now.vertices === count, vertices);
  expect(await sceneOf(page)).toEqual(before);
  expect((await state(page)).running).toBe(false);
  expect(await own()).toBe(work);
  const now = await screenOf(page, 0);
  for (const axis of [0, 1]) expect(now[axis]).toBeCloseTo(corner[axis], 0);
  await expect(page.getByRole('tab', { name: 'Worst' })).toHaveAttribute('aria-selected', 'true');
  await tool(page, 'Share');
  const link = page.getByRole('dialog', { name: 'Share' }).getByRole('textbox', { name: 'Link' });
  await expect(link).toHaveValue(/#link=/);
});

test('Cancel restores what was typed just before, and the run as far as it went', async ({
  page,
}) => {
  await openPage(page);
  const scene = { ...JSON.parse(quadScene(2)), solver: { tolerance: 0 } };
  scene.constraints = [{ kind: 'circle', on: 'faces' }];
  await openText(page, 'endless.shapeup.json', JSON.stringify(scene), 9);
  // What the dialog needs is there the second time.
  const dialog = await openNewMesh(page);
  await waitForState(page, (now) => now.vertices !== 9);
  await dialog.getByRole('button', { name: 'Cancel' }).click();
  await waitForState(page, (now) => now.vertices === 9);
  await page.getByRole('button', { name: 'Run' }).click();
  await waitForState(page, (now) => now.iteration > 1000);
  await page.getByRole('button', { name: 'Examples' }).click();
  const weight = page.getByLabel('Shape weight', { exact: true });
  const begin = page.getByRole('menuitem', { name: 'New mesh' });
  const iteration = await weight.evaluate(
    (field: HTMLInputElement, begin) => {
      field.value = '7';
      field.dispatchEvent(new Event('change', { bubbles: true }));
      (begin as HTMLElement).click();
      return window.shapeUp.state().iteration;
    },
    await begin.elementHandle(),
  );
  await waitForState(page, (now) => now.vertices !== 9);
  await dialog.getByRole('button', { name: 'Cancel' }).click();
  await waitForState(page, (now) => now.vertices === 9 && now.iteration > 0);
  expect((await state(page)).iteration).toBeGreaterThanOrEqual(iteration);
  expect((await sceneOf(page)).weights.shape).toBe(7);
});

test('Undo restores the model before a new mesh, with its undo history', async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  await page.getByRole('button', { name: 'Make panels flat', exact: true }).click();
  await waitForState(page, (now) => !now.running && now.exact?.met);
  const undo = page.getByRole('button', { name: 'Undo', exact: true });
  await expect(undo).toHaveAttribute('title', /^Undo: /);
  const before = await sceneOf(page);
  const title = await undo.getAttribute('title');
  const dialog = await openNewMesh(page);
  await waitForState(page, (now) => now.vertices !== 25);
  await dialog.getByRole('button', { name: 'Create mesh' }).click();
  await expect(undo).toHaveAttribute('title', 'Undo: New mesh (Ctrl+Z)');
  await undo.click();
  await waitForState(page, (now) => now.vertices === 25);
  expect(await sceneOf(page)).toEqual(before);
  await expect(undo).toHaveAttribute('title', title ?? '');
  // There was no way back to the new mesh.
  const redo = page.getByRole('button', { name: 'Redo', exact: true });
  await expect(redo).toHaveAttribute('title', /^Redo: New mesh/);
  await redo.click();
  await waitForState(page, (now) => now.vertices !== 25);
  await undo.click();
  await waitForState(page, (now) => now.vertices === 25);
  await expect(redo).toBeEnabled();
  await undo.click();
  await waitForState(page, (now) => Object.keys(now.constraints).length === 0);
  await expect(redo).toHaveAttribute('title', /^Redo: (?!New mesh)/);
  // Each undone step is redone, and then the new mesh is.
  await redo.click();
  await expect(redo).toHaveAttribute('title', /^Redo: New mesh/);
  await undo.click();
  await waitForState(page, (now) => Object.keys(now.constraints).length === 0);
  await page.getByRole('button', { name: 'Make panels circular', exact: true }).click();
  await waitForState(page, (now) => !now.running && now.exact?.met);
  await expect(redo).toBeDisabled();
});

test('a surface is made between two curves of the model, or inside a boundary', async ({
  page,
}) => {
  await openPage(page);
  const arches = [0, 10].flatMap((y) =>
    [0, 1, 2, 3, 4].map((x) => `v ${3 * x} ${y} ${(0.2 + 0.05 * y) * x * (4 - x)}`),
  );
  const text = `# units: m\n${arches.join('\n')}\nl 1 2 3 4 5\nl 10 9 8 7 6\n`;
  await openText(page, 'arches.obj', text, 10);
  const dialog = await openNewMesh(page);
  await dialog.getByLabel('Shape').selectOption({ label: 'Between curves' });
  await dialog.getByLabel('Size of a panel').fill('2');
  await waitForState(page, (now) => now.faces === 20 && now.vertices === 30);
  await dialog.getByLabel('Made').selectOption('Inside a closed curve');
  await expect(dialog.getByText('None of the curves is closed.')).toBeVisible();
  await dialog.getByLabel('Made').selectOption('Between two curves');
  await waitForState(page, (now) => now.faces === 20);
  await dialog.getByRole('button', { name: 'Create mesh' }).click();
  await expect(dialog).toBeHidden();
  const again = await openNewMesh(page);
  await again.getByLabel('Shape').selectOption({ label: 'Between curves' });
  // The boundary is the only curve, and it is closed.
  await expect(again.getByLabel('Made')).toHaveValue('inside');
  await again.getByLabel('Size of a panel').fill('1.5');
  await waitForState(page, (now) => now.faces > 30);
  await again.getByRole('button', { name: 'Cancel' }).click();
  await waitForState(page, (now) => now.faces === 20);
});

test('the fields are in one column, and what scrolls does not shine through the buttons', async ({
  page,
}) => {
  await openPage(page);
  const dialog = await openNewMesh(page);
  // The list of another dialog moved the first fields outwards.
  const [shape, size] = [
    dialog.getByLabel('Shape'),
    dialog.getByRole('spinbutton').first().locator('xpath=..'),
  ];
  const [one, other] = [await boxOf(shape), await boxOf(size)];
  expect(one.x + one.width).toBeCloseTo(other.x + other.width, 0);
  const behind = await dialog
    .locator('footer')
    .evaluate((footer) => getComputedStyle(footer).backgroundColor);
  expect(behind).not.toBe('rgba(0, 0, 0, 0)');
  // A mesh between curves has their unit: the choice of another one had no effect.
  await expect(dialog.getByLabel('Unit')).toBeVisible();
  await dialog.getByLabel('Shape').selectOption({ label: 'Between curves' });
  await expect(dialog.getByLabel('Unit')).toBeHidden();
  // Half of the words were cut off.
  const room = await boxOf(dialog.getByLabel('Made'));
  const need = await dialog.getByLabel('Made').evaluate((list) => {
    const copy = list.cloneNode(true) as HTMLElement;
    copy.style.cssText = 'position: absolute; width: auto';
    list.after(copy);
    const { width } = copy.getBoundingClientRect();
    copy.remove();
    return width;
  });
  expect(need).toBeLessThanOrEqual(room.width);
});

test.describe('at an address without encryption', () => {
  test.use({ sameDocument: false });

  test('a new mesh is made', async ({ page }) => {
    await page.addInitScript(() =>
      Object.defineProperty(crypto, 'randomUUID', { value: undefined }),
    );
    await openPage(page);
    await expect(await openNewMesh(page)).toBeVisible();
    await expect(page.getByRole('alert')).toBeEmpty();
  });
});

test.describe('on a slow network', () => {
  test.use({ fresh: true });

  test('a new mesh that is begun before the first model has come gives way to it', async ({
    page,
  }) => {
    // The dialog closed when that came, and a mesh stayed that was never saved.
    const release = await hold(page, '**/examples/index.json');
    await page.goto('./');
    await page.waitForFunction(() => Boolean(window.shapeUp));
    await showStep(page, 'Open');
    await page.getByRole('button', { name: 'Draw one' }).click();
    await expect(page.getByRole('status')).toHaveText('Starts when the model is loaded');
    release();
    const dialog = page.getByRole('dialog', { name: 'New mesh' });
    await expect(dialog.getByText(/faces, .* vertices\./)).toBeVisible();
    const { vertices } = await state(page);
    await dialog.getByRole('button', { name: 'Cancel' }).click();
    await waitForState(page, (now, tried) => now.vertices !== tried, vertices);
    await expect(page.getByRole('status')).toContainText('Opened');
  });
});
