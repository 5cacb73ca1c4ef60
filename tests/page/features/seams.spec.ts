// Edges of the model along which a paper model is cut.

import type { Page } from '@playwright/test';
import { openText } from '../actions.ts';
import { openParts, partsPanel } from '../sheets.ts';
import { expect, middleOf, openPage, sceneOf, state, test, waitForState } from '../support.ts';

/** Panels along a side. */
const N = 4;

/** A vault that unrolls into one piece: its rulings are along y. */
function vault() {
  const lines = ['# units: m'];
  for (let j = 0; j <= N; j++)
    for (let i = 0; i <= N; i++)
      lines.push(`v ${i} ${j} ${(1 - 0.2 * (i - N / 2) ** 2).toFixed(3)}`);
  const at = (i: number, j: number) => 1 + i + (N + 1) * j;
  for (let j = 0; j < N; j++)
    for (let i = 0; i < N; i++)
      lines.push(`f ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`);
  return lines.join('\n');
}
const vertex = (i: number, j: number) => i + (N + 1) * j;

const seams = (page: Page) => partsPanel(page).getByRole('group', { name: 'Seams' });
const button = (page: Page, name: string) => seams(page).getByRole('button', { name });
const pieces = (page: Page, count: number) =>
  waitForState(page, (now, count) => now.build?.parts === count, count);

test('paper is cut along the selected edges, as one step, and still is after a reload', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'vault.obj', vault(), (N + 1) ** 2);
  await openParts(page);
  await expect(seams(page), 'panels have no seams').toBeHidden();
  await partsPanel(page).getByLabel('Make').selectOption('paper');
  await pieces(page, 1);
  await expect(button(page, 'Cut along the selected edges')).toBeDisabled();
  await expect(button(page, 'No seams')).toBeDisabled();

  // The line of edges along the ridge.
  await button(page, 'Select edges').click();
  await expect(button(page, 'Select edges')).toBeHidden();
  await page.mouse.dblclick(...(await middleOf(page, [vertex(2, 1), vertex(2, 2)])));
  await expect.poll(async () => (await state(page)).selection.edges).toHaveLength(N);
  await button(page, 'Cut along the selected edges').click();
  await pieces(page, 2);
  await expect(seams(page)).toContainText(`${N} edges are cut.`);
  const { build } = await sceneOf(page);
  expect(build?.seams).toHaveLength(N);
  expect((await state(page)).selection.edges, 'the seams are seen').toEqual([]);

  // One of them is folded again: the others still part nothing.
  await page.mouse.click(...(await middleOf(page, [vertex(2, 1), vertex(2, 2)])));
  await button(page, 'Fold the selected edges').click();
  await expect(seams(page)).toContainText(`${N - 1} edges are cut.`);
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await expect(seams(page)).toContainText(`${N} edges are cut.`);
  await button(page, 'No seams').click();
  await pieces(page, 1);
  await expect(seams(page)).toContainText('select edges of the model');
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await pieces(page, 2);

  await expect
    .poll(() => page.evaluate(() => document.querySelector('#numbers')?.textContent))
    .toContain('Saved in this browser');
  await page.reload();
  await waitForState(page, (now, count) => now.vertices === count, (N + 1) ** 2);
  await openParts(page);
  await pieces(page, 2);
  await expect(seams(page)).toContainText(`${N} edges are cut.`);
  expect((await sceneOf(page)).build?.seams).toEqual(build?.seams);
});
