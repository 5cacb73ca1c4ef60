// Two pictures side by side, iterations in half steps, and histograms of the original.

import type { Locator, Page } from '@playwright/test';
import { downloaded, exported, hidePanels, showPanel, tool } from '../actions.ts';
import { decodePng, type Picture } from '../picture.ts';
import { boxOf, drawn, expect, looks, positionOf, state, test, waitForState } from '../support.ts';

const view = (page: Page) => page.getByRole('application', { name: '3D view' });
const divider = (page: Page) => page.getByRole('slider', { name: 'Divider' });

async function openExample(page: Page, id: string, faces: number) {
  await page.goto(`./#example=${id}`);
  await waitForState(page, (state, faces) => state.faces === faces, faces);
}

/** Returns the picture once it is up to date. */
async function picture(page: Page) {
  await drawn(page);
  return decodePng(await view(page).screenshot());
}

/**
 * Counts the differing pixels between two fractions of the width, above the controls over the view.
 */
function differing(a: Picture, b: Picture, [from, to]: [number, number]) {
  let count = 0;
  for (let y = Math.round(0.1 * a.height); y < 0.7 * a.height; y++) {
    for (let x = Math.round(from * a.width); x < to * a.width; x++) {
      const at = (y * a.width + x) * a.channels;
      if (a.pixels.compare(b.pixels, at, at + 3, at, at + 3) !== 0) count++;
    }
  }
  return count;
}

test('the divider separates two pictures of the same mesh', looks, async ({ page }) => {
  await openExample(page, 'fig-05-planar', 2040);
  for (let k = 0; k < 3; k++) await page.getByRole('button', { name: 'Step' }).click();
  await waitForState(page, (state) => state.iteration === 3);
  await showPanel(page, 'Model');
  await page.getByRole('button', { name: 'Before and after' }).click();
  await expect(divider(page)).toHaveAttribute('aria-valuenow', '50');
  await expect(divider(page)).toHaveAttribute('aria-valuetext', /left .*original; right .*now/);
  await hidePanels(page);
  await divider(page).focus();
  const both = await picture(page);
  await page.keyboard.press('End');
  await expect(divider(page)).toHaveAttribute('aria-valuenow', '100');
  const original = await picture(page);
  await page.keyboard.press('Home');
  await expect(divider(page)).toHaveAttribute('aria-valuenow', '0');
  const now = await picture(page);

  expect(differing(original, now, [0.1, 0.4])).toBeGreaterThan(1000);
  expect(differing(original, now, [0.6, 0.9])).toBeGreaterThan(1000);
  // Each half equals that part of the corresponding single picture.
  expect(differing(both, original, [0.05, 0.45])).toBe(0);
  expect(differing(both, now, [0.55, 0.95])).toBe(0);

  // By arrow keys and by mouse.
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('PageUp');
  await expect(divider(page)).toHaveAttribute('aria-valuenow', '11');
  const area = await boxOf(view(page));
  const from = await boxOf(divider(page));
  await page.mouse.move(from.x + from.width / 2, area.y + 0.3 * area.height);
  await page.mouse.down();
  await page.mouse.move(area.x + 0.75 * area.width, area.y + 0.3 * area.height, { steps: 4 });
  await page.mouse.up();
  await expect(divider(page)).toHaveAttribute('aria-valuenow', '75');
});

test('each side shows its own measure and shape', looks, async ({ page }) => {
  await openExample(page, 'fig-05-circular', 2040);
  await showPanel(page, 'Model');
  await page.getByRole('button', { name: 'beside' }).click();
  const sides = ['Left', 'Right'].map((name) =>
    page.getByRole('group', { name: `${name} picture` }),
  );
  await expect(sides[0]).toBeVisible();
  await expect(sides[0].getByLabel('coloured by')).toHaveValue('e-p');
  await expect(sides[1].getByLabel('coloured by')).toHaveValue('e-c');
  await hidePanels(page);
  const before = await picture(page);
  // The same measure and shape on both sides.
  await sides[1].getByLabel('coloured by').selectOption('e-p');
  await expect(divider(page)).toHaveAttribute('aria-valuetext', /left (.*), now; right \1, now/);
  const after = await picture(page);
  expect(differing(before, after, [0.05, 0.45])).toBe(0);
  expect(differing(before, after, [0.55, 0.95])).toBeGreaterThan(1000);

  // Each histogram follows the shape shown on its side.
  await sides[0].getByLabel('shape').selectOption('original');
  const bars = (side: Locator) => side.getByRole('img');
  await expect(bars(sides[0])).toHaveAccessibleName(/^2040 faces between 0 and 9[^;]*$/);
  const worst = (await bars(sides[0]).getAttribute('aria-label')) ?? '';
  await page.getByRole('button', { name: 'Step' }).click();
  await expect(bars(sides[1])).toHaveAccessibleName(/; originally up to 9/);
  await expect(bars(sides[1])).not.toHaveAccessibleName(new RegExp(`^${worst};`));
  await expect(bars(sides[0])).toHaveAccessibleName(worst);

  // Back to one picture with its own legend.
  await expect(page.getByLabel('Colours to')).toBeHidden();
  await view(page).focus();
  await page.keyboard.press('Escape');
  await expect(divider(page)).toBeHidden();
  await expect(page.getByLabel('Colours to')).toBeVisible();
});

test(
  'both sides show bands, ghost and ground, and a saved picture has bands in both legends',
  looks,
  async ({ page }, { project }) => {
    await openExample(page, 'fig-04-squares', 384);
    await page.getByRole('button', { name: 'Step' }).click();
    await waitForState(page, (state) => state.iteration === 1);
    await view(page).focus();
    await page.keyboard.press('c');
    await expect(divider(page)).toBeVisible();
    const sides = ['Left', 'Right'].map((name) =>
      page.getByRole('group', { name: `${name} picture` }),
    );
    let before = await picture(page);
    const bothChange = async (name: string) => {
      await showPanel(page, 'Energies and display');
      await page.getByRole('checkbox', { name }).check();
      await hidePanels(page);
      const after = await picture(page);
      expect(differing(before, after, [0.02, 0.45]), `${name}, left`).toBeGreaterThan(300);
      expect(differing(before, after, [0.55, 0.98]), `${name}, right`).toBeGreaterThan(300);
      before = after;
    };
    for (const side of sides) await expect(side).not.toContainText('steps of');
    await bothChange('Colours in bands');
    for (const side of sides) await expect(side).toContainText(/steps of \d/);
    await bothChange('Original ghost');
    await bothChange('Ground grid');
    // The size of the ground squares is shown where no legend covers it.
    const scale = page.locator('#scale');
    await expect(scale).toHaveText(/^Grid \d+ m$/);
    const told = await boxOf(scale);
    const onTop = await page.evaluate(
      ([x, y]) => document.elementsFromPoint(x, y).some((over) => over.closest('.split-legend')),
      [told.x + told.width / 2, told.y + told.height / 2],
    );
    expect(onTop).toBe(false);

    // Isolines appear only on the side of the Moved measure.
    await sides[1].getByLabel('coloured by').selectOption({ label: 'Moved' });
    const isolines = await picture(page);
    expect(differing(before, isolines, [0.02, 0.45])).toBe(0);
    expect(differing(before, isolines, [0.55, 0.98])).toBeGreaterThan(1000);

    // In the saved picture both legends have the hard steps of the bands.
    if (project.name === 'phone') return;
    const { bytes } = await exported(page, 'PNG');
    const saved = decodePng(bytes);
    for (const left of [0, 0.5]) expect(coloursAcross(saved, left)).toBeLessThan(24);
  },
);

/**
 * The number of colours in the ramp of the legend that starts at this fraction of the width, at
 * scale 2.
 */
function coloursAcross({ width, height, channels, pixels }: Picture, part: number) {
  const found = new Set();
  for (let x = 18; x < 226; x++) {
    const at = ((height - 2 * 37) * width + part * width + 2 * x) * channels;
    found.add(pixels.readUIntBE(at, 3));
  }
  return found.size;
}

test('the legend outlines the histogram of the original', async ({ page }) => {
  await openExample(page, 'fig-04-squares', 384);
  const bars = page.getByRole('img', { name: /^384 faces between/ });
  await expect(bars).toHaveAccessibleName(/^384 faces between 0 and [\d.]+ mm$/);
  await page.getByRole('button', { name: 'Step' }).click();
  await expect(bars).toHaveAccessibleName(/; originally up to 387 mm$/);
  await expect(bars.locator('.outline')).toBeVisible();
});

test(
  'a local step fits shapes without moving the mesh; the global step moves it like a full step',
  looks,
  async ({ page }) => {
    await openExample(page, 'fig-04-squares', 384);
    await tool(page, 'Step');
    await waitForState(page, (state) => state.iteration === 1);
    const stepped = await positionOf(page, 100);
    await tool(page, 'Reset');
    await waitForState(page, (state) => state.iteration === 0);
    const before = await positionOf(page, 100);
    const bare = await picture(page);

    const status = page.getByRole('status');
    await tool(page, 'Half step');
    await expect(status).toHaveText(
      'Local step done: 384 shapes fitted (square); next: global step',
    );
    expect(await positionOf(page, 100)).toEqual(before);
    // The squares are visible.
    expect(differing(bare, await picture(page), [0, 1])).toBeGreaterThan(1000);

    await tool(page, 'Half step');
    await expect(status).toHaveText(/^Global step done: moved to the least-squares solution/);
    expect(await positionOf(page, 100)).toEqual(stepped);
    expect((await state(page)).iteration).toBe(1);
    await tool(page, 'Undo');
    await waitForState(page, (state) => state.iteration === 0);
    expect(await positionOf(page, 100)).toEqual(before);
    // The squares are gone.
    expect(differing(bare, await picture(page), [0, 1])).toBe(0);
  },
);

test('every other command ends the half step', async ({ page }) => {
  await openExample(page, 'fig-04-squares', 384);
  const isHalfway = async (checked: boolean) => {
    const shown = page.locator('[data-command="half-step"]').first();
    await expect(shown).toHaveAttribute('aria-checked', String(checked));
  };
  for (const other of ['Step', 'Reset', 'Undo']) {
    await tool(page, 'Half step');
    await isHalfway(true);
    await tool(page, other);
    await isHalfway(false);
  }
  await tool(page, 'Half step');
  await isHalfway(true);
  await tool(page, 'Run');
  await isHalfway(false);
  await tool(page, 'Pause');
});

test('angles before and after are plotted and saved', async ({ page }) => {
  await openExample(page, 'fig-07-quality', 1672);
  await page.getByRole('button', { name: 'Step' }).click();
  await waitForState(page, (state) => state.iteration === 1);
  await showPanel(page, 'Model');
  await page.getByRole('button', { name: 'Angles before and after' }).click();
  await expect(page.getByRole('tab', { name: 'Angles' })).toHaveAttribute('aria-selected', 'true');
  const plot = page.getByRole('img', { name: /corners by angle/ });
  await expect(plot).toHaveAccessibleName(
    /^6688 corners by angle. The middle half: originally 70° to 110°, now \d+° to \d+°$/,
  );
  const save = page.getByRole('button', { name: 'Save angles as CSV' });
  const file = await downloaded(page, () => save.click());
  expect(file.name).toBe('fig-07-quality-angles.csv');
  const rows = file.text.trim().split('\n').slice(1);
  const columns = rows.map((row) => row.split(',').map(Number));
  for (const column of [2, 3])
    expect(columns.reduce((sum, row) => sum + row[column], 0)).toBe(6688);

  // Switches tabs by keys.
  await page.getByRole('tab', { name: 'Angles' }).focus();
  await page.keyboard.press('ArrowLeft');
  await expect(page.getByRole('tab', { name: 'Convergence' })).toBeFocused();
  await expect(plot).toBeHidden();
});
