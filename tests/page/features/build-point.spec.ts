// Pointing at a panel in the view or at its piece on the sheets marks the other.

import type { Page } from '@playwright/test';
import { openText } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { openParts, outlinesOf, overPart, partsPanel, settingOf } from '../sheets.ts';
import { expect, openPage, screenOf, state, test, waitForState } from '../support.ts';

test.use({ sameDocument: true });

const N = 4;
const sheets = (page: Page) => partsPanel(page).getByRole('group', { name: 'Sheets' });

/** The centre of a face of the grid on the page. */
async function middleOf(page: Page, face: number): Promise<[number, number]> {
  const corner = Math.floor(face / N) * (N + 1) + (face % N);
  const corners = [corner, corner + 1, corner + N + 1, corner + N + 2];
  const places: [number, number][] = [];
  for (const vertex of corners) places.push(await screenOf(page, vertex));
  const mean = (axis: number) => places.reduce((sum, at) => sum + at[axis] / corners.length, 0);
  return [mean(0), mean(1)];
}

async function openBuild(page: Page) {
  await openPage(page);
  await openText(page, 'roof.obj', `# units: m\n${wavyGrid(N)}`, (N + 1) ** 2);
  await openParts(page);
}

test('a panel under the pointer marks its piece on the sheets, and the piece marks the panel', async ({
  page,
}) => {
  await openBuild(page);
  for (const face of [5, 10]) {
    await page.mouse.move(...(await middleOf(page, face)));
    await expect(sheets(page)).toContainText(`P${face} on sheet-01`);
    const marked = await outlinesOf(partsPanel(page), 'pointed');
    expect(marked).toHaveLength(1);
    const part = (await outlinesOf(partsPanel(page), 'cut')).indexOf(marked[0]);
    const { at } = await overPart(partsPanel(page), part);
    await expect(sheets(page)).toContainText(`P${face} on sheet-01`);
    await page.mouse.click(...at);
    expect((await state(page)).selection.faces).toEqual([face]);
  }
  await partsPanel(page).getByLabel('Material', { exact: true }).hover();
  await expect.poll(() => outlinesOf(partsPanel(page), 'pointed')).toEqual([]);
  await expect(sheets(page)).toContainText('Point at a part');
});

test('the sheet of a piece out of sight is named, and a click brings it into view', async ({
  page,
}) => {
  await openBuild(page);
  const width = await settingOf(page, 'Sheet width, mm');
  await width.fill('45');
  await width.press('Tab');
  await waitForState(page, (now) => now.build?.sheet_mm[0] === 45);
  await partsPanel(page).getByLabel('Sheet height, mm').fill('45');
  await partsPanel(page).getByLabel('Sheet height, mm').press('Tab');
  await waitForState(page, (now) => (now.build?.sheets ?? 0) > 8);
  await partsPanel(page).getByRole('img').first().scrollIntoViewIfNeeded();
  // Points at one panel after the other until one is on the last sheet.
  const last = `sheet-${(await state(page)).build?.sheets}`;
  const line = sheets(page).locator('p').first();
  for (let face = 0; !(await line.textContent())?.includes(last); face++) {
    expect(face).toBeLessThan(N * N);
    await page.mouse.move(...(await middleOf(page, face)));
    await expect(line).toContainText(`P${face} on sheet-`);
  }
  await expect(line).toContainText('click the panel to see it');
  const marked = partsPanel(page).locator('.pointed:not([d=""])');
  await expect(marked).toHaveCount(1);
  await expect(marked).not.toBeInViewport();
  await page.mouse.down();
  await page.mouse.up();
  await expect(marked).toBeInViewport();
});

test('a panel of a paper model marks the piece from which it is folded', async ({ page }) => {
  await openBuild(page);
  await partsPanel(page).getByLabel('Make').selectOption('paper');
  await (await settingOf(page, 'Pieces')).selectOption('strips');
  await waitForState(
    page,
    (now, strips) => now.build?.product === 'paper' && now.build.parts === strips,
    N,
  );
  await page.mouse.move(...(await middleOf(page, 5)));
  await expect.poll(() => outlinesOf(partsPanel(page), 'pointed')).toHaveLength(1);
  await expect(sheets(page)).toContainText(/^S?\w+ on sheet-01/);
});
