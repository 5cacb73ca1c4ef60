// Messages do not cover the controls in use.

import type { Locator } from '@playwright/test';
import { file, wavyGrid } from '../meshes.ts';
import { openText, showStep } from '../actions.ts';
import { boxOf, expect, openPage, screenOf, test, waitForState } from '../support.ts';

/** Whether two elements do not overlap. */
async function apart(one: Locator, other: Locator) {
  const [a, b] = await Promise.all([boxOf(one), boxOf(other)]);
  return (
    a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y
  );
}

test('a message does not cover the constraint dialog', async ({ page }, { project }) => {
  await openPage(page);
  await page.getByLabel('Open file').setInputFiles(file('notes.txt', 'not a mesh'));
  const message = page.getByRole('alert').getByText('cannot be read');
  await expect(message).toBeVisible();
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Add constraint' }).click();
  const dialog = page.getByRole('dialog', { name: 'New constraint' });
  await expect(dialog).toBeVisible();
  const desktop = [1440, 1280, 1120, 1000, 760].map((width) => ({ width, height: 900 }));
  const sizes = project.name === 'phone' ? [{ width: 390, height: 844 }] : desktop;
  for (const size of sizes) {
    await page.setViewportSize(size);
    const place = page.getByRole('alert').locator('.message');
    await expect.poll(() => apart(place, dialog), `at ${size.width}`).toBe(true);
    await expect(message).toBeInViewport({ ratio: 1 });
    // The dialog is in its place.
    const panel = page.getByRole('complementary', { name: 'Steps', includeHidden: true });
    if (project.name !== 'phone') expect(await apart(place, panel), `at ${size.width}`).toBe(true);
    // Nothing else lies under the pointer either.
    await dialog.getByRole('button', { name: 'Close' }).click({ trial: true });
  }
  await dialog.getByRole('button', { name: 'Close' }).click();
  await expect(dialog).toBeHidden();
  await expect(message).toBeVisible();
  const buttons = page.getByRole('group', { name: 'Camera' });
  for (const size of sizes) {
    await page.setViewportSize(size);
    const place = page.getByRole('alert').locator('.message');
    await expect.poll(() => apart(place, buttons), `at ${size.width}`).toBe(true);
  }
});

// Only a phone has the sheet.
const phone = { tag: '@phone' };
test('on a phone no tab is selected while the sheet is closed', phone, async ({ page }) => {
  await openPage(page);
  const chosen = page.getByRole('tablist', { name: 'Steps' }).getByRole('tab', { selected: true });
  await expect(chosen).toHaveCount(0);
  await page.getByRole('tab', { name: 'Check' }).click();
  await expect(chosen).toHaveText('Check');
  await page.getByRole('tab', { name: 'Check' }).click();
  await expect(chosen).toHaveCount(0);
});

test(
  'on a phone a press for all panels in the sheet closes it, so that the verdict is seen',
  phone,
  async ({ page }) => {
    await openPage(page);
    await openText(page, 'grid.obj', wavyGrid(6), 49);
    const card = page.getByRole('group', { name: 'Panels', exact: true });
    // The buttons are in the sheet once the card has the verdict.
    for (const press of [card, page.locator('#step-shape')]) {
      await press.getByRole('button', { name: 'Make panels flat' }).click();
      await expect(card).toContainText('panels are flat within');
      await page.getByRole('tab', { name: 'Shape' }).click();
      await expect(card).toBeHidden();
    }
  },
);

test('the verdict on a run lies beside the framed model, not over it', async ({ page }) => {
  await openPage(page);
  // A wall, as high as the view.
  const obj = wavyGrid(6).replace(/^v (\S+) (\S+) (\S+)/gm, 'v $1 $3 $2');
  const scene = {
    ...{ format: 'shape-up-scene', version: 1, up: 'z', mesh: { file: 'wall.obj' } },
    constraints: [{ kind: 'plane', on: 'faces', require: { within: 0.01 } }],
    ...{ closeness: { to: 'rest' }, weights: { shape: 1000, close: 1, smooth: 1 } },
  };
  await page
    .getByLabel('Open file')
    .setInputFiles([file('wall.shapeup.json', JSON.stringify(scene)), file('wall.obj', obj)]);
  await waitForState(page, ({ vertices }) => vertices === 49);
  await page.getByRole('button', { name: 'Run', exact: true }).click();
  const verdict = page.getByRole('group', { name: 'Verdict' });
  await expect(verdict).toBeVisible();
  const beside = async () => {
    // It is replaced when what is within its tolerance is made exact.
    const box = await verdict.boundingBox();
    if (!box) return false;
    const { y, height } = box;
    const corners = await Promise.all([0, 6, 42, 48].map((vertex) => screenOf(page, vertex)));
    const places = corners.map(([, at]) => at);
    return Math.min(...places) > y + height || Math.max(...places) < y;
  };
  await expect.poll(beside).toBe(true);
});
