// The paper's comparisons, run in the worker: plots, table and cancelling.

import type { Locator, Page } from '@playwright/test';
import { downloaded, openExample, openText, showPanel } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { decodePng, distinctColours } from '../picture.ts';
import { expect, openPage, state, test, waitForState } from '../support.ts';

test.use({ sameDocument: true });

/** Opens the dialog of an example's experiment. */
async function openExperiment(page: Page, word: string) {
  await openExample(page, word);
  await showPanel(page, 'Model');
  await page.getByRole('button', { name: 'Compare methods' }).click();
  const dialog = page.getByRole('dialog');
  await expect(dialog.getByRole('button', { name: 'Run all' })).toBeVisible();
  return dialog;
}

/** The cells of a table row: iterations, seconds, quantities, outcome. */
const cells = (dialog: Locator, method: string | RegExp) =>
  dialog.getByRole('row').filter({ hasText: method }).getByRole('cell').allTextContents();

/** The number of colours in a plot; each curve adds some. */
const coloursOf = async (plot: Locator) => distinctColours(decodePng(await plot.screenshot()));

test('methods are compared on any model with constraints, and the plots are saved', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(6), 49);
  await showPanel(page, 'Model');
  const offer = page.getByRole('button', { name: 'Compare methods' });
  await expect(offer).toBeDisabled();
  await page.getByRole('button', { name: 'Make panels circular' }).first().click();
  await waitForState(page, (now) => !now.running && now.iteration > 0);
  const { iteration } = await state(page);

  await showPanel(page, 'Model');
  await offer.click();
  const dialog = page.getByRole('dialog');
  await dialog.getByLabel('At most').fill('20');
  await dialog.getByRole('button', { name: 'Run all' }).click();
  await expect(dialog.getByRole('status')).toHaveText('All methods have ended.');
  const energies: Record<string, number> = {};
  for (const method of ['accelerated', 'Mean-centred', 'Gradient descent', /^BFGS/]) {
    energies[String(method)] = parseFloat((await cells(dialog, method))[2]);
  }
  expect(energies.accelerated).toBe(Math.min(...Object.values(energies)));
  expect(energies[String(/^BFGS/)]).toBeLessThan(energies['Gradient descent']);

  const table = await downloaded(page, () => dialog.getByRole('button', { name: 'CSV' }).click());
  expect(table.text).toMatch(/^method,iteration,seconds,energy\naccelerated,0,/);
  const svg = dialog.getByRole('button', {
    name: /^Save SVG: Energy above the lowest.*iterations/,
  });
  const figure = await downloaded(page, () => svg.click());
  expect(figure.name).toMatch(/iterations\.svg$/);
  expect(figure.text.match(/<polyline/g)).toHaveLength(6);
  await dialog.getByRole('button', { name: 'Close experiment' }).click();
  // The open model is unchanged.
  expect((await state(page)).iteration).toBe(iteration);
});

test('five methods are run, plotted, tabulated and saved', async ({ page }) => {
  await openPage(page);
  const dialog = await openExperiment(page, 'Animal, pressed flat');
  const iteration = (await state(page)).iteration;
  const plots = dialog.getByRole('img');
  await expect(plots).toHaveCount(2);
  const blank = await coloursOf(plots.first());
  await dialog.getByLabel('At most').fill('25');
  await dialog.getByRole('button', { name: 'Run all' }).click();
  await expect(dialog.getByRole('status')).toHaveText('All methods have ended.');

  const energies = [];
  for (const method of [
    'Mean-centred',
    'Not centred',
    'Gradient descent',
    'L-BFGS',
    'accelerated',
  ]) {
    const [iterations, seconds, energy, ended] = await cells(dialog, method);
    expect(iterations, method).toBe('25');
    expect(parseFloat(seconds), method).toBeGreaterThan(0);
    expect(ended, method).toBe('limit of iterations');
    energies.push(parseFloat(energy));
  }
  const [centred, ...others] = energies;
  const accelerated = others.pop();
  expect(Math.min(...others)).toBeGreaterThan(10 * centred);
  expect(accelerated).toBeLessThan(centred);
  expect(await coloursOf(plots.first())).toBeGreaterThan(blank + 20);

  const saving = page.waitForEvent('download');
  await dialog.getByRole('button', { name: 'Save CSV' }).click();
  expect((await saving).suggestedFilename()).toBe('fig-10-collapse.csv');
  await dialog.getByRole('button', { name: 'Close experiment' }).click();
  await expect(dialog).toBeHidden();
  // The open model is unchanged.
  expect((await state(page)).iteration).toBe(iteration);
});

test('both methods reach the same error on the strip', async ({ page }) => {
  await openPage(page);
  const dialog = await openExperiment(page, 'Strip with collapsing edges');
  await dialog.getByRole('button', { name: 'Run all' }).click();
  await expect(dialog.getByRole('status')).toHaveText('All methods have ended.', {
    timeout: 90_000,
  });
  const fitted = await cells(dialog, 'Shape-Up');
  const penalised = await cells(dialog, 'Penalty');
  expect([fitted.at(-1), penalised.at(-1)]).toEqual(['reached', 'reached']);
  expect(parseFloat(fitted[2])).toBeLessThan(0.93 * parseFloat(penalised[2]));
});

test('an experiment can be cancelled and run again', async ({ page }) => {
  await openPage(page);
  const dialog = await openExperiment(page, 'Animal, pressed flat');
  await dialog.getByLabel('At most').fill('100000');
  await dialog.getByRole('button', { name: 'Run all' }).click();
  await expect(dialog.getByRole('progressbar')).toBeVisible();
  await expect
    .poll(async () => parseFloat((await cells(dialog, 'Mean-centred'))[0]))
    .toBeGreaterThan(3);
  await dialog.getByRole('button', { name: 'Cancel' }).click();
  await expect(dialog.getByRole('status')).toHaveText('Cancelled.');
  const stopped = await cells(dialog, 'Mean-centred');
  // Once the solver has answered twice, any pending work has had its turn.
  for (let turn = 0; turn < 2; turn++) await page.evaluate(() => window.shapeUp.settled());
  expect(await cells(dialog, 'Mean-centred')).toEqual(stopped);
  await dialog.getByLabel('At most').fill('2');
  await dialog.getByRole('button', { name: 'Run all' }).click();
  await expect(dialog.getByRole('status')).toHaveText('All methods have ended.');
  expect((await cells(dialog, 'Mean-centred'))[0]).toBe('2');
});
