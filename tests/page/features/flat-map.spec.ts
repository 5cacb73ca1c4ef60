// Parametrisation: a flat map beside the model.

import type { Page } from '@playwright/test';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { program } from '../../../.scripts/project.mjs';
import { openExample, openText, openVariations, runToTheEnd, saved, showStep } from '../actions.ts';
import { holdingAnswers } from '../answers.ts';
import { box, tube, wavyGrid } from '../meshes.ts';
import { differingBytes } from '../picture.ts';
import {
  boxOf,
  drawn,
  expect,
  looks,
  openPage,
  pictureOf,
  screenOf,
  settled,
  test,
  waitForState,
} from '../support.ts';

test.use({ sameDocument: true });

const map = (page: Page) => page.getByRole('application', { name: 'Flat map' });
const value = (page: Page, name: string) => page.locator(`dt:text-is("${name}") + dd`);

async function parametrize(page: Page) {
  await showStep(page, 'Check');
  await page.getByRole('button', { name: 'Flatten' }).click();
  await expect(page.getByRole('heading', { name: 'Flat map' })).toBeVisible();
}

/** Runs the command line on a mesh; returns its report and the file that it writes. */
function commandLine(obj: string, ...options: string[]) {
  const folder = mkdtempSync(join(tmpdir(), 'shape-up-'));
  const [mesh, out, report] = ['mesh.obj', 'uv.obj', 'report.json'].map((n) => join(folder, n));
  try {
    writeFileSync(mesh, obj);
    const asked = ['--out', out, '--report', report, ...options];
    execFileSync(program, ['parametrize', mesh, ...asked]);
    return { report: JSON.parse(readFileSync(report, 'utf8')), text: readFileSync(out, 'utf8') };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('an example is flattened, and Escape returns to the model', looks, async ({ page }) => {
  await openPage(page);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
  await openExample(page, 'Hypar');
  await expect(map(page)).toBeHidden();
  await parametrize(page);
  await expect(map(page)).toBeVisible();
  await expect(page.getByRole('status')).toHaveText(/^Flattened in /);
  await expect(value(page, 'Flipped triangles')).toHaveText('0');
  await expect(page.getByRole('img', { name: /^Histogram of the angle distortion/ })).toBeVisible();

  // Side by side; one above the other in a narrow window.
  const view = page.getByRole('application', { name: '3D view' });
  const [whole, part] = [await boxOf(view), await boxOf(map(page))];
  expect(part.width / whole.width).toBeCloseTo(0.5, 1);
  expect(part.height / whole.height).toBeCloseTo(1, 1);

  // The checkerboard is on the model and the map for as long as it is chosen.
  const onModel = page.getByLabel('On the model');
  const onMap = page.getByLabel('On the map');
  await expect(onModel).toHaveValue('checks');
  const withChecks = await pictureOf(page, view);
  await onModel.selectOption('errors');
  expect(differingBytes(await pictureOf(page, view), withChecks)).toBeGreaterThan(
    0.02 * withChecks.pixels.length,
  );
  await expect(page.getByLabel('Squares')).toBeHidden();
  const withErrors = await pictureOf(page, map(page));
  await onMap.selectOption('checks');
  expect(differingBytes(await pictureOf(page, map(page)), withErrors)).toBeGreaterThan(
    0.05 * withErrors.pixels.length,
  );
  await expect(page.getByLabel('Squares')).toBeVisible();

  // A drag pans the map without moving the model.
  const before = await pictureOf(page, map(page));
  const corner = await screenOf(page, 0);
  await page.mouse.move(part.x + part.width / 2, part.y + part.height / 2);
  await page.mouse.down();
  await page.mouse.move(part.x + part.width / 2 + 40, part.y + part.height / 2, { steps: 3 });
  await page.mouse.up();
  expect(differingBytes(await pictureOf(page, map(page)), before)).toBeGreaterThan(1000);
  expect(await screenOf(page, 0)).toEqual(corner);

  await page.keyboard.press('Escape');
  await expect(map(page)).toBeHidden();
  await expect(page.getByRole('heading', { name: 'Flat map' })).toBeHidden();
});

test(
  'the distortion has the colours of its legend, whatever is chosen for measures',
  looks,
  async ({ page }) => {
    await openPage(page);
    await waitForState(page, (now) => now.renderer.startsWith('web'));
    await openExample(page, 'Hypar');
    const flattened = async () => {
      await parametrize(page);
      await page.getByLabel('On the model').selectOption('errors');
      await drawn(page);
      const view = page.getByRole('application', { name: '3D view' });
      const ramp = await map(page).locator('.ramp').getAttribute('style');
      return [ramp, await pictureOf(page, view), await pictureOf(page, map(page))] as const;
    };
    const [ramp, ...pictures] = await flattened();
    await page.keyboard.press('Escape');
    await page.getByLabel('Colour map', { exact: true }).selectOption('turbo');
    await page.getByLabel('Colours in bands').check();
    const [rampThen, ...picturesThen] = await flattened();
    expect(rampThen).toBe(ramp);
    pictures.forEach((before, i) => {
      expect(differingBytes(picturesThen[i], before)).toBeLessThan(0.001 * before.pixels.length);
    });
  },
);

test('the numbers and the file equal those of the command line', async ({ page }) => {
  await openPage(page);
  const obj = wavyGrid(6);
  await openText(page, 'grid.obj', obj, 49);
  await parametrize(page);
  // One of the settings; tests/solve/conformal.rs compares all with a reference.
  const { report, text } = commandLine(obj, '--weights', 'lscm', '--norm', 'vertices');
  await page.getByLabel('Weight of a polygon').selectOption('lscm');
  await page.getByLabel('Keep from shrinking').selectOption('vertices');
  const { mean, max } = report.quasi_conformal;
  await expect(value(page, 'Mean distortion')).toHaveText(mean.toFixed(4));
  await expect(value(page, 'Largest distortion')).toHaveText(max.toFixed(4));
  await expect(value(page, 'Flipped triangles')).toHaveText(String(report.flipped));
  const file = await saved(page, 'Export');
  const places = (obj: string) =>
    (obj.match(/^vt .*$/gm) ?? []).map((line) => line.split(' ').map(Number));
  const [ours, theirs] = [places(file.text), places(text)];
  expect(ours).toHaveLength(49);
  const apart = ours.map(([, x, y], v) => Math.hypot(x - theirs[v][1], y - theirs[v][2]));
  expect(Math.max(...apart)).toBeLessThan(1e-6);
  // Without a map there are no texture coordinates.
  await page.getByRole('button', { name: 'Back to the model' }).click();
  expect((await saved(page, 'Export')).text).not.toContain('vt ');
});

test('a map belongs to the flattened shape, and can be renewed once the shape changes', async ({
  page,
}) => {
  await openPage(page);
  await parametrize(page);
  const mean = (await value(page, 'Mean distortion').textContent()) as string;
  const again = page.getByRole('button', { name: 'Flatten again' });
  await expect(again).toBeHidden();
  await runToTheEnd(page);
  await showStep(page, 'Check');
  await again.click();
  await expect(again).toBeHidden();
  await expect(value(page, 'Mean distortion')).not.toHaveText(mean);
  // Another model has no map yet.
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  await expect(map(page)).toBeHidden();
});

test('a variation moves the model since it was flattened, without an iteration', async ({
  page,
}) => {
  const panel = await openVariations(page, 4);
  const slider = panel.getByRole('slider').first();
  await expect(slider).toBeVisible();
  await parametrize(page);
  const again = page.getByRole('button', { name: 'Flatten again' });
  await expect(again).toBeHidden();
  await slider.focus();
  for (let k = 0; k < 9; k++) await slider.press('ArrowRight');
  await expect(again).toBeVisible();
  await panel.getByRole('button', { name: 'Back', exact: true }).click();
  await expect(again).toBeHidden();
});

test('a model without faces is not offered a map, and one without a boundary gets the reason', async ({
  page,
}) => {
  await openPage(page);
  const corners = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n';
  await openText(page, 'line.obj', `${corners}l 1 2 3 4\n`, 4);
  await showStep(page, 'Check');
  const button = page.getByRole('button', { name: 'Flatten' });
  await expect(button).toBeHidden();
  await page.keyboard.press('u');
  await openText(page, 'closed.obj', `${corners}f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n`, 4);
  await expect(button).toBeVisible();
  await parametrize(page);
  await expect(page.getByText('has no boundary: the map folds over itself')).toBeVisible();
  await expect(page.getByLabel('Keep from shrinking')).toBeHidden();
});

test(
  'faces that the map flips are outlined, counted, and found on the model',
  looks,
  async ({ page }) => {
    await openPage(page);
    await waitForState(page, (now) => now.renderer.startsWith('web'));
    // The map of a sheet has no folds; the map of a box must have some.
    await openText(page, 'grid.obj', wavyGrid(4), 25);
    await parametrize(page);
    const show = page.getByRole('button', { name: 'Show flipped faces' });
    await expect(value(page, 'Flipped triangles')).toHaveText('0');
    await expect(show).toBeHidden();
    await expect(map(page).getByText('flipped')).toBeHidden();
    const red = async () => {
      const { pixels: drawn, channels } = await pictureOf(page, map(page));
      let count = 0;
      for (let at = 0; at < drawn.length; at += channels)
        count += Number(drawn[at] > 180 && drawn[at + 1] < 80 && drawn[at + 2] < 90);
      return count;
    };
    expect(await red()).toBe(0);

    await page.keyboard.press('Escape');
    await openText(page, 'box.obj', box(), 8);
    await parametrize(page);
    await expect(show).toBeVisible();
    const flipped = Number(await value(page, 'Flipped triangles').textContent());
    expect(flipped).toBeGreaterThan(0);
    expect(flipped).toBeLessThanOrEqual(12);
    await expect(map(page).getByText(/^\d+ triangles? flipped$/)).toBeVisible();
    await expect.poll(red).toBeGreaterThan(80);
    await show.click();
    const { selection } = await page.evaluate(() => window.shapeUp.state());
    expect(selection.faces.length).toBeGreaterThan(0);
    expect(selection.faces.length).toBeLessThanOrEqual(flipped);
    await expect(page.getByRole('status')).toHaveText(/^\d faces? selected$/);
    // Both stay marked: the outlines are drawn on the map, and are longer after zooming in.
    await expect.poll(red).toBeGreaterThan(150);
  },
);

test.describe('with choices of their own', () => {
  // Choices of a flat map stay in the page, for all tests after them.
  test.use({ sameDocument: false, fresh: true });

  test('a map that folds offers settings with fewer folds', async ({ page }) => {
    await openPage(page);
    // Two boundary loops: the map folds with the default settings, but not with others. A round tube
    // has several maps of equal energy, between which rounding decides.
    await openText(page, 'tube.obj', tube({ width: 0.5, taper: 0.1, power: 2 }), 60);
    await parametrize(page);
    await expect(value(page, 'Flipped triangles')).not.toHaveText('0');
    // They are looked for unasked only if the map took less than 0.3 s.
    const look = page.getByRole('button', { name: 'Look for settings that flip fewer' });
    const found = page.getByText(/flips none, mean distortion/);
    await expect(look.or(found)).toBeVisible();
    if (await look.isVisible()) await look.click();
    await expect(found).toBeVisible();
    await page.getByRole('button', { name: 'Use these settings' }).click();
    await expect(value(page, 'Flipped triangles')).toHaveText('0');
    await expect(page.getByLabel('Weight of a polygon')).toHaveValue('lscm');
    await expect(page.getByRole('button', { name: 'Use these settings' })).toBeHidden();
  });

  test('one that is closed meanwhile does not come back', async ({ page }) => {
    const answers = await holdingAnswers(page);
    await openPage(page);
    await openText(page, 'wavy.obj', wavyGrid(6), 49);
    await parametrize(page);
    await expect(page.getByRole('status')).toHaveText(/^Flattened in /);
    await answers.hold('parametrize');
    await page.getByLabel('Weight of a polygon').selectOption('one');
    await expect(page.getByRole('status')).toHaveText('Flattening …');
    await answers.come('jobs: parametrize');
    await page.keyboard.press('Escape');
    await answers.release();
    await settled(page);
    await expect(page.getByRole('heading', { name: 'Flat map' })).toBeHidden();
    await expect(page.getByRole('status')).not.toHaveText('Flattening …');
  });
});
