// Fitted circles over the surface: visible lines from near, no solid patch of ink from afar.

import type { Page } from '@playwright/test';
import { openExample, runToTheEnd, showStep } from '../actions.ts';
import { decodePng, type Picture } from '../picture.ts';
import { expect, looks, openPage, seen, test } from '../support.ts';

test.use({ viewport: { width: 900, height: 640 } });

/** The picture of the view. */
async function picture(page: Page) {
  const draw = async () => {
    const blob = await window.shapeUp.picture({ legend: false });
    return new Promise<string>((done) => {
      const reader = new FileReader();
      reader.onload = () => done((reader.result as string).split(',')[1]);
      reader.readAsDataURL(blob);
    });
  };
  const base64 = await seen(page, () => page.evaluate(draw));
  return decodePng(Buffer.from(base64, 'base64'));
}

/** Whether a pixel differs clearly between two pictures. */
const differs = (a: Picture, b: Picture, at: number) =>
  [0, 1, 2].some((part) => Math.abs(a.pixels[at + part] - b.pixels[at + part]) > 24);

/** The fraction of differing pixels in their bounding box, and the width of that box. */
function covered(a: Picture, b: Picture) {
  const columns = new Set<number>();
  const rows = new Set<number>();
  let count = 0;
  for (let at = 0; at < a.pixels.length; at += a.channels) {
    if (!differs(a, b, at)) continue;
    count += 1;
    columns.add((at / a.channels) % a.width);
    rows.add(Math.floor(at / a.channels / a.width));
  }
  const span = (places: Set<number>) => Math.max(...places) - Math.min(...places) + 1;
  return count === 0
    ? { part: 0, width: 0 }
    : { part: count / (span(columns) * span(rows)), width: span(columns) };
}

test('circles are thin lines from near, and fade from afar', looks, async ({ page }) => {
  await openPage(page);
  await openExample(page, 'Canopy');
  await runToTheEnd(page);
  await showStep(page, 'Check');
  const shown = page.getByLabel('Best-fitting shapes');
  const both = async () => {
    await shown.check();
    const circles = await picture(page);
    await shown.uncheck();
    return covered(circles, await picture(page));
  };
  const near = await both();
  expect(near.width).toBeGreaterThan(300);
  expect(near.part).toBeGreaterThan(0.03);

  const view = page.getByRole('application', { name: '3D view' });
  await view.hover();
  for (let turn = 0; turn < 8; turn++) await page.mouse.wheel(0, 240);
  const far = await both();
  expect(far.part).toBeLessThan(0.01);
});
