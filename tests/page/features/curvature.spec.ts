// Curvature of a surface: its directions and lines, Gauss and mean curvature as colours, and what
// they mean for panels.

import type { Page } from '@playwright/test';
import { openText, showStep, tool } from '../actions.ts';
import { gridText } from '../meshes.ts';
import { expect, looks, openPage, pictureOf, test } from '../support.ts';

test.use({ sameDocument: true });

/** A saddle of n by n quads, in metres, whose edges are at 45° to its lines of curvature. */
const hypar = (n: number) =>
  `# units: m\n${gridText(n, (x, y) => 0.1 * (x - n / 2) * (y - n / 2))}`;

async function openCurvature(page: Page) {
  await tool(page, 'Curvature');
  return page.getByRole('region', { name: 'Curvature' });
}

/** Counts the pixels of the view in which red, or blue, clearly dominates. */
async function tinted(page: Page) {
  const { pixels, channels } = await pictureOf(page);
  const found = { red: 0, blue: 0 };
  for (let i = 0; i < pixels.length; i += channels) {
    const [r, g, b] = [pixels[i], pixels[i + 1], pixels[i + 2]];
    if (r > g + 60 && r > b + 60) found.red += 1;
    if (b > r + 60 && b > g + 20) found.blue += 1;
  }
  return found;
}

test(
  'directions and lines of curvature are drawn over a saddle, and disappear with the card',
  looks,
  async ({ page }) => {
    await openPage(page);
    await openText(page, 'hypar.obj', hypar(12), 169);
    const before = await tinted(page);
    const card = await openCurvature(page);
    await expect(card.getByText(/edges are \d+° off the lines of curvature/)).toBeVisible();
    await expect(async () => {
      const now = await tinted(page);
      expect(now.red).toBeGreaterThan(before.red + 300);
      expect(now.blue).toBeGreaterThan(before.blue + 300);
    }).toPass();
    await card.getByLabel('Lines', { exact: true }).selectOption('Lines of curvature');
    await expect(card.getByLabel('Spacing of the lines')).toHaveAttribute('placeholder', /\d/);
    // The spacing that was found can be typed to keep it.
    const spacing = card.getByLabel('Spacing of the lines');
    const found = (await spacing.getAttribute('placeholder')) ?? '';
    await spacing.fill(found);
    await spacing.press('Enter');
    await expect(spacing).toHaveValue(String(Number(found)));
    await card.getByLabel('Spacing of the lines').fill('0.0001');
    await card.getByLabel('Spacing of the lines').press('Enter');
    await expect(card.getByText('expected a distance from')).toBeVisible();
    await card.getByLabel('Spacing of the lines').fill('1.5');
    await card.getByLabel('Spacing of the lines').press('Enter');
    await expect(card.getByText('expected a distance from')).toBeHidden();
    await page.getByRole('button', { name: 'Close curvature' }).click();
    await expect(card).toBeHidden();
    await expect(async () => {
      expect((await tinted(page)).red).toBeLessThan(before.red + 50);
    }).toPass();
  },
);

test('Gauss and mean curvature are coloured around zero, with units in metres', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'hypar.obj', hypar(12), 169);
  await showStep(page, 'Check');
  const colours = page.getByLabel('Colour by');
  const legend = page.locator('#legend');
  await colours.selectOption('Gauss curvature');
  // In the middle it is -(0.1 / m)^2.
  await expect(legend.getByRole('img')).toHaveAttribute(
    'aria-label',
    /^144 faces between −0\.0\d+ 1\/m² and 0\.0\d+ 1\/m²$/,
  );
  await expect(page.getByRole('spinbutton', { name: 'Limit' })).toBeHidden();
  const [low, high] = ['from', 'to'].map((end) => page.getByLabel(`Colours ${end}`));
  expect(await low.inputValue()).toBe(`−${await high.inputValue()}`);
  await high.fill('0.02');
  await high.press('Enter');
  await expect(low).toHaveValue('−0.0200');
  // A range that ended at 0 had the colours of another map.
  await high.fill('0');
  await high.press('Enter');
  expect(await high.evaluate((field) => field.matches(':invalid'))).toBe(true);
  await high.press('Escape');
  await expect(high).toHaveValue('0.0200');
  await colours.selectOption('Mean curvature');
  await expect(legend).toContainText('Mean curvature');
});

test('the high end of a range around zero stays above zero', async ({ page }) => {
  // Its low end is its mirror: past the middle the range was upside down, and all had one colour.
  await openPage(page);
  await openText(page, 'hypar.obj', hypar(12), 169);
  await showStep(page, 'Check');
  await page.getByLabel('Colour by').selectOption('Mean curvature');
  const high = page.getByRole('slider', { name: 'High end of the range' });
  await high.press('Home');
  await expect(high).toHaveAttribute('aria-valuenow', '51');
  await expect(page.getByLabel('Colours to')).not.toHaveValue(/^−/);
});
