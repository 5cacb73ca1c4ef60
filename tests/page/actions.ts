// User actions, by the names that the user sees. On a phone the steps are behind tabs and some tools
// are behind "More".

import type { Page } from '@playwright/test';
import { expect, openPage, waitForState } from './support.ts';
import { file, wavyGrid } from './meshes.ts';

/** Shows a step, which may be closed, or on a phone behind its tab. */
export async function showStep(page: Page, name: Step) {
  const place = page.locator(`#step-${name.toLowerCase()}`);
  const heading = place.locator('> summary');
  const tab = page.getByRole('tab', { name, exact: true });
  if (await tab.isVisible()) {
    if (!(await place.isVisible())) await tab.click();
  } else if (!(await place.evaluate((one: HTMLDetailsElement) => one.open))) {
    await heading.click();
  }
  await expect(place).toHaveJSProperty('open', true);
  await expect(place).toBeVisible();
}

type Step = 'Open' | 'Shape' | 'Move' | 'Check' | 'Build';

/** Closes the sheet on a phone, so that the view is large. */
export async function hidePanels(page: Page) {
  const open = page.getByRole('tablist', { name: 'Steps' }).getByRole('tab', { selected: true });
  const bar = page.getByRole('toolbar', { name: 'Main tools' });
  if ((await bar.isVisible()) && (await open.count()) > 0) await open.click();
}

/** Opens the text of a file through the file input and waits until it is the current model. */
export async function openText(page: Page, name: string, text: string, vertices: number) {
  await page.getByLabel('Open file').setInputFiles(file(name, text));
  await waitForState(page, (state, count) => state.vertices === count, vertices);
}

/** Opens the page with a wavy grid of n by n quads, and waits for the view. */
export async function openGrid(page: Page, n: number) {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(n), (n + 1) ** 2);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
}

/** Opens the example whose title contains the word. */
export async function openExample(page: Page, word: string) {
  await tool(page, 'Examples');
  await page.getByRole('menuitem', { name: word }).click();
  await expect(page.getByRole('status')).toHaveText(new RegExp(`Opened the example .*${word}`));
  await hidePanels(page);
}

/** Adds a constraint through the dialog and waits until it is in the list. */
export async function addConstraint(page: Page, kind: string, where: string) {
  const before = await constraintCount(page);
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Add constraint' }).click();
  const dialog = page.getByRole('dialog', { name: 'New constraint' });
  await dialog.getByRole('radio', { name: kind, exact: true }).check();
  await dialog.getByRole('radio', { name: where, exact: true }).check();
  await dialog.getByRole('button', { name: 'Add', exact: true }).click();
  await expect(dialog).toBeHidden();
  await expect.poll(() => constraintCount(page)).toBe(before + 1);
}

/** Returns the number of constraints in the scene. */
export const constraintCount = (page: Page) =>
  page.evaluate(() => window.shapeUp.scene().constraints.length);

/** Opens a wavy grid of n by n faces, makes its panels flat, and opens the panel of variations. */
export async function openVariations(page: Page, n: number) {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(n), (n + 1) ** 2);
  await page.getByRole('button', { name: 'Make panels flat', exact: true }).click();
  await waitForState(page, (now) => !now.running && now.exact?.met);
  await showStep(page, 'Move');
  await page.getByRole('button', { name: 'Variations', exact: true }).click();
  return page.getByRole('region', { name: 'Variations' });
}

/** Runs until the solver has converged. */
export async function runToTheEnd(page: Page) {
  await page.getByRole('button', { name: 'Run' }).click();
  return waitForState(page, (state) => state.converged && !state.running);
}

/** Clicks a button, which may be in a step that is not shown, or behind "More". */
export async function tool(page: Page, name: string) {
  const options = { name, exact: true, includeHidden: true };
  const buttons = page.getByRole('button', options).or(page.getByRole('switch', options));
  const visible = buttons.filter({ visible: true });
  if (!(await visible.first().isVisible())) {
    const [step] = await buttons.evaluateAll((all) =>
      all.flatMap((one) => one.closest('.step')?.querySelector('h2')?.textContent ?? []),
    );
    if (step) await showStep(page, step.split(' ')[0] as Step);
    else await page.getByRole('button', { name: 'More', exact: true }).click();
  }
  await visible.click();
}

/** Clicks the button and returns the text of the saved file. */
export async function saved(page: Page, name: string) {
  return downloaded(page, () => tool(page, name));
}

/** Exports in the given format and returns the saved file. */
export async function exported(page: Page, format: string) {
  await tool(page, 'More formats');
  const dialog = page.getByRole('dialog', { name: 'More formats' });
  const file = await downloaded(page, () =>
    dialog.getByRole('button', { name: new RegExp(`^${format}`) }).click(),
  );
  await expect(dialog).toBeHidden();
  return file;
}

/** Returns the file that `action` saves. */
export async function downloaded(page: Page, action: () => unknown) {
  const download = page.waitForEvent('download');
  await action();
  const got = await download;
  const chunks = [];
  for await (const chunk of await got.createReadStream()) chunks.push(chunk);
  const bytes = Buffer.concat(chunks);
  return { name: got.suggestedFilename(), bytes, text: bytes.toString() };
}
