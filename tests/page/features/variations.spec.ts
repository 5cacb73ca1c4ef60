// From an opened mesh to exact panels and a variation that is kept, undone, redone, shared and
// opened again.

import type { Locator, Page } from '@playwright/test';
import { openText, openVariations, showStep } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { holdingAnswers } from '../answers.ts';
import {
  boxOf,
  drawn,
  everything,
  expect,
  openPage,
  settled,
  state,
  test,
  waitForState,
} from '../support.ts';

test.use({ sameDocument: true });

const N = 6;
const VERTICES = (N + 1) ** 2;

const farthest = (a: number[], b: number[]) =>
  Math.max(...a.map((value, i) => Math.abs(value - b[i])));
const positions = (page: Page) => page.evaluate(() => [...window.shapeUp.positions()]);

/** Moves a slider by keys and releases it. */
async function slide(slider: Locator, key: string, presses: number) {
  await slider.focus();
  for (let i = 0; i < presses; i++) await slider.press(key);
}

test('a variation is exact, kept, undone, shared and opened again', async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), VERTICES);
  await page.getByRole('button', { name: 'Make panels flat', exact: true }).click();
  await waitForState(page, (now) => !now.running && now.exact?.met);
  const verdict = page.getByRole('group', { name: 'Verdict' });
  const make = verdict.getByRole('button', { name: 'Make exact' });
  await expect(make.or(verdict.getByText(/Also made exact/))).toBeVisible();
  if (await make.isVisible()) await make.click();
  await waitForState(page, (now) => now.exact?.met && now.exact.max_distance < 1e-8);

  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Variations', exact: true }).click();
  const panel = page.getByRole('region', { name: 'Variations' });
  await expect(panel.getByRole('slider')).toHaveCount(8);
  const start = await positions(page);
  // Two variations add up; on each release the shape is made exact.
  await slide(panel.getByRole('slider', { name: 'Variation 1', exact: true }), 'ArrowRight', 20);
  await slide(panel.getByRole('slider', { name: 'Variation 3', exact: true }), 'ArrowLeft', 10);
  const keep = panel.getByRole('button', { name: 'Keep', exact: true });
  await expect(keep).toBeEnabled();
  const varied = await waitForState(page, (now) => now.exact?.met);
  expect(varied.exact?.max_distance).toBeLessThan(1e-8);
  await keep.click();
  const strip = panel.getByRole('group', { name: 'Kept', exact: true });
  await expect(strip.getByRole('button', { name: 'Variation 1', exact: true })).toHaveAttribute(
    'aria-current',
  );
  const kept = await everything(page);
  expect(farthest(kept.positions, start)).toBeGreaterThan(0.01);
  expect((await state(page)).exact?.met).toBe(true);

  // One step of undo, and of redo.
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await expect(strip).toBeHidden();
  expect(await positions(page)).toEqual(start);
  await page.getByRole('button', { name: 'Redo', exact: true }).click();
  const table = panel.getByRole('table', { name: 'Kept shapes compared' });
  await expect(table.getByRole('row')).toHaveCount(3);
  expect(await positions(page)).toEqual(kept.positions);

  // Goes back to the start, and to the kept variant again.
  await strip.getByRole('button', { name: 'Start', exact: true }).click();
  await expect.poll(() => positions(page)).toEqual(start);
  await strip.getByRole('button', { name: 'Variation 1', exact: true }).click();
  await expect.poll(() => positions(page)).toEqual(kept.positions);

  // Sliders that were moved but not kept are reset on closing.
  await expect(panel.getByRole('slider')).toHaveCount(8);
  await slide(panel.getByRole('slider', { name: 'Variation 2', exact: true }), 'ArrowRight', 5);
  await expect.poll(() => positions(page)).not.toEqual(kept.positions);
  await panel.getByRole('button', { name: 'Close variations' }).click();
  await expect.poll(() => positions(page)).toEqual(kept.positions);

  await page.getByRole('button', { name: 'Share', exact: true }).click();
  const link = page.getByRole('dialog').getByRole('textbox').first();
  await expect(link).toHaveValue(/#/);
  const address = await link.inputValue();
  await page.goto('about:blank');
  await page.goto(address);
  await waitForState(page, (now) => now.vertices > 0 && now.exact?.met);
  const opened = await everything(page);
  expect(opened.positions).toEqual(kept.positions);
  expect(opened.scene.variants).toEqual(kept.scene.variants);

  // A second press before the strip is drawn anew does not remove the next shape, and a press on that
  // opens it.
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Variations', exact: true }).click();
  const next = strip.getByRole('button', { name: 'Variation 1', exact: true });
  await strip.getByRole('button', { name: 'Remove Start' }).evaluate(
    (button: HTMLElement, next) => {
      button.click();
      button.click();
      (next as HTMLElement).click();
    },
    await next.elementHandle(),
  );
  await expect(table.getByRole('row')).toHaveCount(2);
  await settled(page);
  await expect(page.getByRole('alert')).toBeEmpty();

  // The last column was cut off.
  await page.setViewportSize({ width: 320, height: 640 });
  await table.scrollIntoViewIfNeeded();
  const { x, width } = await boxOf(table);
  expect(x + width).toBeLessThanOrEqual(320);
});

test('a variation that is left while it is made exact does not come back', async ({ page }) => {
  // Shape and leaving come from two workers.
  const answers = await holdingAnswers(page);
  const panel = await openVariations(page, N);
  await expect(panel.getByRole('slider')).not.toHaveCount(0);
  const start = await positions(page);
  const slider = panel.getByRole('slider').first();
  await answers.hold('go');
  // Once: each further press would be made exact in its turn.
  await slide(slider, 'ArrowRight', 1);
  await panel.getByRole('button', { name: 'Back', exact: true }).click();
  await expect(slider).toHaveValue('0');
  await answers.come('jobs: go');
  await answers.release();
  await drawn(page);
  expect(await positions(page)).toEqual(start);
  await expect(panel.getByRole('button', { name: 'Back', exact: true })).toBeDisabled();
});

test('the panel does not end a run that begins while it is open', async ({ page }) => {
  // It looked for variations at every edit, and brought the shape to rest for that: of the panels made
  // circular with the panel open, three quarters were not.
  const panel = await openVariations(page, 16);
  await expect(panel.getByRole('slider')).not.toHaveCount(0);
  await page.getByRole('button', { name: 'Make panels circular', exact: true }).click();
  await expect(page.getByRole('button', { name: /^Undo$/ })).toHaveAttribute('title', /circular/);
  const ended = await waitForState(page, (now) => !now.running && now.constraints.circle);
  expect(ended.converged).toBe(true);
  expect(ended.exact?.met).toBe(true);
  await expect(panel.getByRole('slider')).not.toHaveCount(0);
});

test('the sliders go on after an edit while a variation is shown', async ({ page }) => {
  const panel = await openVariations(page, N);
  const slider = panel.getByRole('slider').first();
  const keep = panel.getByRole('button', { name: 'Keep', exact: true });
  await expect(slider).toBeVisible();
  const start = await positions(page);
  await slide(slider, 'ArrowRight', 5);
  await expect(keep).toBeEnabled();
  // An edit that keeps the shape leaves the variation, and the search begins anew.
  const tolerance = page.getByRole('spinbutton', { name: 'Tolerance' });
  await tolerance.fill('2');
  await tolerance.press('Enter');
  await expect(slider).toHaveValue('0');
  await expect.poll(() => positions(page)).toEqual(start);
  await expect(panel.getByText('Move the sliders')).toBeVisible();
  await slide(slider, 'ArrowRight', 5);
  await expect(keep).toBeEnabled();
  expect(await positions(page)).not.toEqual(start);
});

test('the panel is found among the commands, once there is an exact shape', async ({ page }) => {
  // It was a button only.
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(2), 9);
  const option = page.getByRole('option', { name: /^Variations/ });
  await page.keyboard.press('Control+k');
  await page.keyboard.type('variations');
  await expect(option).toHaveAttribute('aria-disabled', 'true');
  await page.keyboard.press('Escape');
  const panel = await openVariations(page, 2);
  await panel.getByRole('button', { name: 'Close variations' }).click();
  await page.keyboard.press('Control+k');
  await page.keyboard.type('variations');
  await page.keyboard.press('Enter');
  await expect(panel).toBeVisible();
});

test('a model without faces is offered no variations, and is told why', async ({ page }) => {
  // The button opened a panel that closed itself without a word.
  await openPage(page);
  const scene = {
    ...{ format: 'shape-up-scene', version: 1 },
    mesh: { positions: [0, 1, 2, 3].map((x) => [x, x % 2, 0]), faces: [], curves: [[0, 1, 2, 3]] },
    constraints: [{ kind: 'line', on: 'curves', require: 'exact' }],
  };
  await page.evaluate((given) => window.shapeUp.open(given, 'curve.shapeup.json'), scene);
  await page.getByRole('button', { name: 'Run', exact: true }).click();
  await waitForState(page, (now) => !now.running && now.exact?.met);
  await showStep(page, 'Shape');
  const button = page.getByRole('button', { name: 'Variations', exact: true });
  await expect(button).toBeDisabled();
  await expect(button).toHaveAttribute('title', 'For models with faces');
});
