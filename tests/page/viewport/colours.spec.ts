// The colours of the faces.

import type { Page } from '@playwright/test';
import {
  addConstraint,
  hidePanels,
  openExample,
  openText,
  runToTheEnd,
  showStep,
  tool,
} from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { colourAt, decodePng, differingBytes, type Picture } from '../picture.ts';
import {
  boxOf,
  drawn,
  expect,
  looks,
  middleOfPicture,
  openPage,
  screenOf,
  seen,
  test,
  waitForState,
  windowOf,
} from '../support.ts';

test.use({ sameDocument: true });

test("faces are coloured by their constraint's measure until the user chooses another", async ({
  page,
}) => {
  await openPage(page);
  await showStep(page, 'Check');
  const colours = page.getByLabel('Colour by');
  const legend = page.getByText('Fit range');
  await expect(colours).toHaveValue('circularity');
  await expect(legend).toBeVisible();
  await openExample(page, 'Hypar');
  await expect(colours).toHaveValue('planarity');

  // A mesh from a file has no constraints.
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  await expect(colours).toHaveValue('');
  await expect(legend).toBeHidden();
  await addConstraint(page, 'Circle', 'each face');
  await expect(legend).toBeVisible();
  await showStep(page, 'Check');
  await expect(colours).toHaveValue('circularity');

  await colours.selectOption('planarity');
  await tool(page, 'Undo');
  await waitForState(page, (now) => now.constraints.circle === undefined);
  await addConstraint(page, 'Circle', 'each face');
  await showStep(page, 'Check');
  await expect(colours).toHaveValue('planarity');
});

test('faces can be coloured by their distance from any constraint', async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  await addConstraint(page, 'Square', 'each face');
  await showStep(page, 'Check');
  await expect(page.getByLabel('Colour by')).toHaveValue('residual');
  await expect(page.getByText('Fit range')).toBeVisible();
  await expect.poll(() => worst(page)).toBeGreaterThan(0);
  const before = await worst(page);
  await runToTheEnd(page);
  await expect.poll(() => worst(page)).toBeLessThan(0.2 * before);
});

/** The worst value, which the legend shows. */
async function worst(page: Page) {
  const [, value] = /Worst ([\d.e-]+)/.exec(await page.locator('#legend').innerText()) ?? [];
  return Number(value);
}

test('rounding does not colour flat faces', async ({ page }) => {
  await openPage(page);
  // Exactly flat, up to rounding of these decimals.
  const corners = [0, 0.1, 0.2, 0.3].flatMap((x) => [0, 0.7].map((y) => [x, y, x / 3 + y / 7]));
  const rows = corners.map((corner) => `v ${corner.join(' ')}`);
  await openText(page, 'flat.obj', `${rows.join('\n')}\nf 1 2 4 3\nf 3 4 6 5\nf 5 6 8 7\n`, 8);
  await addConstraint(page, 'Plane', 'each face');
  await expect(page.getByText('Worst 0', { exact: true })).toBeVisible();
  await showStep(page, 'Check');
  await expect(page.getByTitle('Shape energy, without its weight')).toHaveText('0');
});

/** How much bluer than red the centre of a face of an n by n grid is in a picture. */
async function bluerThanRed(page: Page, picture: Picture, n: number, face: number) {
  const first = Math.floor(face / n) * (n + 1) + (face % n);
  const [a, b] = [await screenOf(page, first), await screenOf(page, first + n + 2)];
  const scale = picture.width / windowOf(page).width;
  const [red, , blue] = colourAt(picture, (scale * (a[0] + b[0])) / 2, (scale * (a[1] + b[1])) / 2);
  return blue - red;
}

test(
  'if no measure is shown, faces have the colours of their constraints',
  looks,
  async ({ page }) => {
    const n = 4;
    await openPage(page);
    await waitForState(page, (now) => now.renderer.startsWith('web'));
    await openText(page, 'grid.obj', wavyGrid(n), 25);
    const tints = async () => {
      await hidePanels(page);
      // Moves pointer and focus away from the rows.
      const view = page.getByRole('application', { name: '3D view' });
      await view.focus();
      await view.hover({ position: { x: 5, y: 5 } });
      const picture = await seen(page, async () => decodePng(await page.screenshot()));
      const [first, second] = [0, n * n - 1];
      return [
        await bluerThanRed(page, picture, n, first),
        await bluerThanRed(page, picture, n, second),
      ];
    };
    const [plain] = await tints();

    // Blue circles everywhere, and a red sphere through the corners of the first face.
    await addConstraint(page, 'Circle', 'each face');
    await page.keyboard.press('3');
    await hidePanels(page);
    const [a, b] = [await screenOf(page, 0), await screenOf(page, n + 2)];
    await page.mouse.click((a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
    await waitForState(page, (now) => now.selection.faces.length === 1);
    await addConstraint(page, 'Sphere', 'whole selection together');
    await page.keyboard.press('Escape');
    await showStep(page, 'Check');
    await page.getByLabel('Colour by').selectOption('');
    const [round, others] = await tints();
    expect(round).toBeLessThan(plain - 20);
    expect(others).toBeGreaterThan(plain + 20);

    // A constraint that is off has no colour; the one behind it shows.
    await showStep(page, 'Shape');
    await page.getByRole('switch', { name: /^Sphere/ }).uncheck();
    await waitForState(page, (now) => now.constraints.sphere === undefined);
    expect((await tints())[0]).toBeGreaterThan(plain + 20);
    await tool(page, 'Undo');
    await waitForState(page, (now) => now.constraints.sphere === 1);
    expect((await tints())[0]).toBeLessThan(plain - 20);
  },
);

test(
  'residuals are arrows to the projected shapes, until they are zero',
  looks,
  async ({ page }) => {
    await openPage(page);
    await waitForState(page, (now) => now.renderer.startsWith('web'));
    await openText(page, 'grid.obj', wavyGrid(4), 25);
    await addConstraint(page, 'Plane', 'each face');
    /** The number of bytes of the picture that the arrows change, with outlines shown. */
    const changes = async () => {
      await showStep(page, 'Check');
      const [outlines, arrows] = ['Outlines of the best fit', 'Arrows to the best fit'].map(
        (name) => page.getByRole('checkbox', { name }),
      );
      const before = await middleOfPicture(page);
      await outlines.check();
      const outlined = await middleOfPicture(page);
      expect(differingBytes(outlined, before)).toBeGreaterThan(2000);
      await arrows.check();
      const changed = differingBytes(await middleOfPicture(page), outlined);
      await arrows.uncheck();
      await outlines.uncheck();
      // Out of a million: ambient occlusion is computed anew.
      expect(differingBytes(await middleOfPicture(page), before)).toBeLessThan(1500);
      return changed;
    };
    const rough = await changes();
    expect(rough).toBeGreaterThan(500);
    await runToTheEnd(page);
    expect(await changes()).toBeLessThan(0.2 * rough);
  },
);

test('the legend counts the faces within a tolerance', async ({ page }) => {
  await openPage(page);
  await showStep(page, 'Check');
  const colours = page.getByLabel('Colour by');
  const names = await colours.getByRole('option').allTextContents();
  expect(names.length).toBeGreaterThan(10);
  await colours.selectOption('Planarity: diagonals');
  await hidePanels(page);
  const tolerance = page.getByLabel('Limit', { exact: true });
  const within = page.getByTitle('Panels within the tolerance');
  const histogram = page.getByRole('img', { name: /^432 faces between 0 and .* %$/ });
  await expect(histogram).toBeVisible();
  const set = async (value: string) => {
    await tolerance.fill(value);
    await tolerance.press('Enter');
  };
  await set('1000');
  await expect(within).toHaveText('432 of 432 within');
  await set('1');
  await expect(within).toHaveText(/^(?!432)\d+ of 432 within$/);
  const before = Number.parseInt((await within.textContent()) ?? '', 10);
  await runToTheEnd(page);
  const after = () => within.textContent().then((text) => Number.parseInt(text ?? '', 10));
  await expect.poll(after).toBeGreaterThan(before + 100);

  await page.getByLabel('Colours to').fill('2,5');
  await page.getByLabel('Colours to').press('Enter');
  await tolerance.focus();
  await expect(page.getByLabel('Colours to')).toHaveValue('2.50');
});

/** Bytes, of a million, that may differ when ambient occlusion is computed anew. */
const FOUND_ANEW = 60;

/** The ends of the range as shown in the legend. */
const rangeOf = async (page: Page) =>
  Promise.all(['Colours from', 'Colours to'].map((name) => page.getByLabel(name).inputValue()));

test('choosing a measure again restores the same picture', looks, async ({ page }) => {
  await openPage(page);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
  // An intermediate shape, better than the start but not exact yet.
  const press = (name: string) => page.getByRole('button', { name, exact: true }).click();
  await press('Reset');
  await waitForState(page, (now) => now.iteration === 0);
  for (let k = 1; k <= 5; k++) {
    await press('Step');
    await waitForState(page, (now, steps) => now.iteration === steps, k);
  }
  await showStep(page, 'Check');
  const colours = page.getByLabel('Colour by');
  // A tolerance that some errors exceed.
  await page.getByLabel('Tolerance').fill('0.1');
  await page.getByLabel('Tolerance').press('Enter');
  await expect(page.getByLabel('Colours from')).toHaveValue('0.100');
  const before = [await rangeOf(page), await middleOfPicture(page)] as const;
  await page.getByRole('button', { name: 'Fit range' }).click();
  await expect.poll(() => rangeOf(page)).not.toEqual(before[0]);
  await colours.selectOption('planarity');
  await expect(page.locator('#legend')).toContainText('Planarity');
  await drawn(page);
  await colours.selectOption('circularity');
  await expect.poll(() => rangeOf(page)).toEqual(before[0]);
  expect(differingBytes(await middleOfPicture(page), before[1])).toBeLessThan(FOUND_ANEW);
  // Shows all values, then returns to the range.
  const map = page.getByLabel('Colour map', { exact: true });
  await map.selectOption('Viridis');
  await expect(page.getByLabel('Colours from')).toHaveValue('0');
  expect(differingBytes(await middleOfPicture(page), before[1])).toBeGreaterThan(2000);
  const viridis = await middleOfPicture(page);
  for (const other of ['Cividis', 'Diverging', 'Grey']) {
    await map.selectOption(other);
    expect(differingBytes(await middleOfPicture(page), viridis)).toBeGreaterThan(2000);
  }
  await map.selectOption('Beyond tolerance');
  expect(differingBytes(await middleOfPicture(page), before[1])).toBeLessThan(FOUND_ANEW);
});

test(
  'the ends of the range are dragged and moved by keys; the scale can be logarithmic',
  looks,
  async ({ page }) => {
    await openPage(page);
    await waitForState(page, (now) => now.renderer.startsWith('web'));
    const high = page.getByRole('slider', { name: 'High end of the range' });
    const low = page.getByRole('slider', { name: 'Low end of the range' });
    await expect(high).toHaveAttribute('aria-valuenow', '100');
    const automatic = await rangeOf(page);
    const before = await middleOfPicture(page);
    await high.focus();
    await page.keyboard.press('Shift+ArrowLeft');
    await expect(high).toHaveAttribute('aria-valuenow', '90');
    expect(differingBytes(await middleOfPicture(page), before)).toBeGreaterThan(500);
    const { x, y, width, height } = await boxOf(high);
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 - 80, y + height / 2, { steps: 4 });
    await page.mouse.up();
    await expect
      .poll(async () => Number((await rangeOf(page))[1]))
      .toBeLessThan(0.8 * Number(automatic[1]));
    await high.dblclick();
    await expect.poll(() => rangeOf(page)).toEqual(automatic);
    await low.focus();
    await page.keyboard.press('ArrowRight');
    await expect.poll(() => rangeOf(page)).not.toEqual(automatic);
    await page.keyboard.press('Delete');
    await expect.poll(() => rangeOf(page)).toEqual(automatic);

    await page.getByLabel('Log scale').check();
    expect(differingBytes(await middleOfPicture(page), before)).toBeGreaterThan(500);
    expect(await rangeOf(page)).toEqual(automatic);
  },
);

test('the legend tells the sides of a face, and can be put away', async ({ page }) => {
  await openPage(page);
  const legend = page.locator('#legend');
  await expect(legend.getByText('back of a face')).toBeVisible();
  await showStep(page, 'Check');
  const map = page.getByLabel('Colour map', { exact: true });
  await map.selectOption('Viridis');
  // Values have their colours on both sides.
  await expect(legend.getByText('back of a face')).toBeHidden();
  await map.selectOption('Beyond tolerance');
  await page.getByLabel('Legend of the colours').uncheck();
  await expect(legend).toBeHidden();
  // The status bar has its numbers.
  await expect(page.locator('#numbers').getByText('worst panel')).toBeVisible();
  await page.getByLabel('Legend of the colours').check();
  await legend.getByRole('button', { name: 'Close the legend' }).click();
  await expect(legend).toBeHidden();
});

test('errors are in the unit of the tolerance, beside how far the mesh moved', async ({ page }) => {
  await openPage(page);
  const scene = {
    ...{ format: 'shape-up-scene', version: 1, units: 'm', up: 'z' },
    mesh: { positions: [] as number[][], faces: [] as number[][] },
    constraints: [{ kind: 'plane', on: 'faces' }],
  };
  // One of the four faces has an error of much more than a decimetre.
  for (let i = 0; i < 9; i++)
    scene.mesh.positions.push([i % 3, Math.floor(i / 3), i === 8 ? 2 : 0]);
  scene.mesh.faces = [0, 1, 3, 4].map((at) => [at, at + 1, at + 4, at + 3]);
  await openText(page, 'm.shapeup.json', JSON.stringify(scene), 9);
  const legend = page.locator('#legend');
  await expect(page.getByLabel('Tolerance')).toHaveValue('1');
  await expect(page.getByTitle('Panels within the tolerance')).toHaveText('3 of 4 within');
  await expect(legend).toContainText(/Worst 398 mm/);
  await showStep(page, 'Shape');
  const row = page.getByRole('list', { name: 'Constraints' }).getByRole('listitem');
  // The row says no value that the legend says.
  const inRow = row.getByText(/^worst \d+ mm/);
  await expect(inRow).toHaveCount(1);
  await expect(inRow).toBeHidden();
  await expect(row).toContainText('beyond tolerance');
  await expect(legend).not.toContainText('Moved');
  // The tolerance is a tick on the colours, and moves along them.
  const tick = legend.locator('.tick');
  const placeOfTick = () => tick.evaluate((one) => Number.parseFloat(one.style.left));
  await expect(tick).toBeVisible();
  const before = await placeOfTick();
  await page.getByLabel('Tolerance').fill('50');
  await page.getByLabel('Tolerance').press('Enter');
  await expect.poll(placeOfTick).toBeGreaterThan(before);
  await page.getByLabel('Tolerance').fill('1');
  await page.getByLabel('Tolerance').press('Enter');
  await expect.poll(placeOfTick).toBeLessThan(1);
  await runToTheEnd(page);
  await expect(legend).toContainText(/Moved \d.* m, mean \d/);
  // Each number is there once.
  await expect(page.locator('#numbers').getByText('moved')).toBeHidden();
  await expect(page.getByRole('complementary', { name: 'Steps' })).not.toContainText(/Moved \d/);
  // Another measure keeps the tolerance.
  await page.getByLabel('Tolerance').fill('200');
  await page.getByLabel('Tolerance').press('Enter');
  // The remaining error is rounding.
  await expect(legend).toContainText(/Worst 0 m\s+Moved/);
  // Beside a legend of something else the row says it.
  await showStep(page, 'Check');
  await page.getByRole('combobox', { name: 'Colour by' }).selectOption('displacement');
  await showStep(page, 'Shape');
  await expect(row.getByText(/^worst 0/)).toBeVisible();
});

test('the fields of the range are not rendered with every frame', async ({ page }) => {
  // They followed the distribution of the values, which each frame changes.
  await openPage(page);
  const n = 32;
  await openText(page, 'roof.obj', wavyGrid(n), (n + 1) ** 2);
  await addConstraint(page, 'Plane', 'each face');
  await showStep(page, 'Check');
  const end = page.getByLabel('Colours to');
  await end.fill('50');
  await end.press('Enter');
  await expect(end).toHaveValue('50.0');
  // To render a field is to compare its value.
  const renders = await end.evaluateHandle((field: HTMLInputElement) => {
    const { get, set } = Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, 'value') ?? {};
    const counted = { count: 0 };
    Object.defineProperty(field, 'value', {
      get() {
        counted.count++;
        return get?.call(field);
      },
      set: (value) => set?.call(field, value),
    });
    return counted;
  });
  await runToTheEnd(page);
  // A run changes the document, too.
  expect((await renders.jsonValue()).count).toBeLessThanOrEqual(2);
});
