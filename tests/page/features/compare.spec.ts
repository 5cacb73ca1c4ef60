// Iterations in half steps; the histogram and the angles of the original beside those of now.

import type { Page } from '@playwright/test';
import { exported, showStep, tool } from '../actions.ts';
import type { Picture } from '../picture.ts';
import { expect, looks, pictureOf, positionOf, state, test, waitForState } from '../support.ts';

async function openExample(page: Page, id: string, faces: number) {
  await page.goto(`./#example=${id}`);
  await waitForState(page, (state, faces) => state.faces === faces, faces);
}

/** Counts the differing pixels above the controls over the view. */
function differing(a: Picture, b: Picture) {
  let count = 0;
  for (let y = Math.round(0.1 * a.height); y < 0.7 * a.height; y++) {
    for (let x = 0; x < a.width; x++) {
      const at = (y * a.width + x) * a.channels;
      if (a.pixels.compare(b.pixels, at, at + 3, at, at + 3) !== 0) count++;
    }
  }
  return count;
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
    const bare = await pictureOf(page);

    const status = page.getByRole('status');
    await tool(page, 'Half step');
    await expect(status).toHaveText(
      'Local step done: 384 shapes fitted (square); next: global step',
    );
    expect(await positionOf(page, 100)).toEqual(before);
    // The squares are visible.
    expect(differing(bare, await pictureOf(page))).toBeGreaterThan(1000);

    await tool(page, 'Half step');
    await expect(status).toHaveText(/^Global step done: moved to the least-squares solution/);
    expect(await positionOf(page, 100)).toEqual(stepped);
    expect((await state(page)).iteration).toBe(1);
    await tool(page, 'Undo');
    await waitForState(page, (state) => state.iteration === 0);
    expect(await positionOf(page, 100)).toEqual(before);
    // The squares are gone.
    expect(differing(bare, await pictureOf(page))).toBe(0);
  },
);

test('every other command ends the half step', async ({ page }) => {
  await openExample(page, 'fig-04-squares', 384);
  const isHalfway = async (checked: boolean) => {
    const shown = page.getByRole('switch', { name: 'Half step', includeHidden: true });
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
});

test('angles before and after are plotted and saved', async ({ page }) => {
  await openExample(page, 'fig-07-quality', 1672);
  await page.getByRole('button', { name: 'Step' }).click();
  await waitForState(page, (state) => state.iteration === 1);
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Angles before and after' }).click();
  await expect(page.getByRole('tab', { name: 'Angles' })).toHaveAttribute('aria-selected', 'true');
  const plot = page.getByRole('img', { name: /corners by angle/ });
  await expect(plot).toHaveAccessibleName(
    /^6688 corners by angle. The middle half: originally 70° to 110°, now \d+° to \d+°$/,
  );
  const file = await exported(page, 'Angles');
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
