// Windows smaller than those of the other tests: no control lies beyond the edge of the window.

import type { Page } from '@playwright/test';
import { openText } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { expect, openPage, test, waitForState } from '../support.ts';

/** Names of the buttons that are cut off by the window, and cannot be scrolled to. */
const cutOff = (page: Page) =>
  page.evaluate(() => {
    const scrolls = (one: Element | null): boolean =>
      one !== null &&
      (/auto|scroll/.test(getComputedStyle(one).overflowX) || scrolls(one.parentElement));
    return [...document.querySelectorAll('button')]
      .filter((button) => button.checkVisibility() && !scrolls(button.parentElement))
      .filter((button) => {
        const { left, right, width } = button.getBoundingClientRect();
        return width > 1 && (left < -1 || right > innerWidth + 1);
      })
      .map((button) => button.ariaLabel ?? button.textContent.trim());
  });

for (const [width, height] of [
  [320, 568],
  [700, 500],
  [760, 900],
])
  test(`every button is in a window of ${width} by ${height} pixels`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await openPage(page);
    await openText(page, 'roof.obj', wavyGrid(6), 49);
    await expect(page.getByRole('button', { name: 'Something else' })).toBeVisible();
    expect(await cutOff(page)).toEqual([]);
    await page.evaluate(() => document.getElementById('build-button')?.click());
    await expect(page.getByRole('region', { name: 'Build: parts and sheets' })).toBeVisible();
    await expect(page.getByRole('button', { name: 'Close build: parts and sheets' })).toBeVisible();
    // The buttons of its advice come with the parts.
    await waitForState(page, (now) => now.build !== null);
    await expect(page.getByRole('button', { name: /^Joint .* on the sheet / })).toBeVisible();
    expect(await cutOff(page)).toEqual([]);
  });
