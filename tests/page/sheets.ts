// The sheets in the parts panel: each kind of line and each mark is one path per sheet.

import type { Locator } from '@playwright/test';

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
