// The panel of parts and its sheets: each kind of line and each mark is one path per sheet.

import type { Locator, Page } from '@playwright/test';
import { unzipSync } from 'fflate';
import type { BuildReport } from '../../www/pkg/engine/shape_up.js';
import { showStep } from './actions.ts';
import { expect, waitForState, type PageState } from './support.ts';

export const partsPanel = (page: Page) =>
  page.getByRole('region', { name: 'Build: parts and sheets' });

/** The report in a state of the page with parts. */
export function reportOf({ build }: PageState): BuildReport {
  if (!build) throw new Error('the page has no parts');
  return build;
}

/** Opens the panel of parts, and waits for them. */
export async function openParts(page: Page) {
  await showStep(page, 'Build');
  await page.getByRole('button', { name: 'Build', exact: true }).click();
  await expect(partsPanel(page)).toBeVisible();
  return reportOf(await waitForState(page, (now) => now.build !== null));
}

/** The field of a setting of this name, unfolded. */
export async function settingOf(page: Page, name: string) {
  const field = partsPanel(page).getByLabel(name);
  await field.evaluate((own) => own.closest('details')?.setAttribute('open', ''));
  return field;
}

/** Enters a number into a field and leaves the field. */
export async function setField(page: Page, label: string, value: number) {
  const field = await settingOf(page, label);
  await field.fill(String(value));
  await field.press('Tab');
}

/** The files of an archive by name. */
export const filesOf = (bytes: Uint8Array) =>
  Object.fromEntries(
    Object.entries(unzipSync(bytes)).map(([name, content]) => [name, Buffer.from(content)]),
  );

/** The outlines in the paths of a kind, sheet by sheet. */
export async function outlinesOf(region: Locator, kind: string) {
  const paths = region.locator(`.sheets .${kind}`);
  const lines = await paths.evaluateAll((all) => all.map((path) => path.getAttribute('d') ?? ''));
  return lines.flatMap((line: string) => line.match(/M[^M]+/g) ?? []);
}

/**
 * Moves the pointer to the centre of a part on the first sheet; returns that position and the
 * outline of the part.
 */
export async function overPart(region: Locator, part: number) {
  const outline = (await outlinesOf(region, 'cut'))[part];
  const sheet = region.getByRole('img').first();
  await sheet.scrollIntoViewIfNeeded();
  const at = await sheet.evaluate((svg: SVGSVGElement, outline) => {
    const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    path.setAttribute('d', outline);
    svg.append(path);
    const { x, y, width, height } = path.getBBox();
    path.remove();
    const middle = new DOMPoint(x + width / 2, y + height / 2).matrixTransform(
      svg.getScreenCTM() ?? undefined,
    );
    return [middle.x, middle.y] as const;
  }, outline);
  await region.page().mouse.move(...at);
  return { at, outline };
}
