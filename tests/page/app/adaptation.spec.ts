// Preferences of the system or browser: reduced motion, forced colours, zoomed text.

import { openText, runToTheEnd } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { boxOf, expect, openPage, test, visit, waitForState } from '../support.ts';

test('with reduced motion nothing moves by itself', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  for (const address of ['./', './gallery.html']) {
    await page.goto(address);
    await expect(page.getByRole('heading', { level: 1 })).toBeVisible();
    const moving = await page.evaluate(() =>
      [...document.querySelectorAll('*')]
        .filter((part) => {
          const { transitionDuration, animationName } = getComputedStyle(part);
          return parseFloat(transitionDuration) > 0 || animationName !== 'none';
        })
        .map((part) => part.outerHTML.slice(0, 80)),
    );
    expect(moving, address).toEqual([]);
  }
});

test('with forced colours, selected controls still look different from others', async ({
  page,
}) => {
  await page.emulateMedia({ forcedColors: 'active' });
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(3), 16);
  /** Whether two controls differ in frame or colour. */
  const differ = (a: string, b: string) =>
    page.evaluate(
      (names) => {
        const [one, other] = names.map((name) => {
          const style = getComputedStyle(document.querySelector(name) as Element);
          return [style.borderTopColor, style.borderTopWidth, style.color].join();
        });
        return one !== other;
      },
      [a, b],
    );
  expect(await differ('[data-command=tool-drag]', '[data-command=tool-select]')).toBe(true);
  expect(await differ('[data-command=undo]', '[data-command=reset]')).toBe(true);
  await page.keyboard.press('b');
  expect(await differ('[data-command=tool-drag]', '[data-command=tool-select]')).toBe(true);
  await page.keyboard.press('Tab');
  const outline = await page.evaluate(() => {
    const at = document.activeElement as Element;
    const shown = at.matches('[type=file]') ? (at.parentElement as Element) : at;
    return getComputedStyle(shown).outlineStyle;
  });
  expect(outline).not.toBe('none');
});

test.describe('at 200 % zoom', () => {
  // The CSS size of a 1440 by 900 window at 200 % zoom.
  test.use({ viewport: { width: 720, height: 450 }, deviceScaleFactor: 2 });

  test('every tool is there, and nothing lies outside the window', async ({ page }) => {
    await visit(page);
    await waitForState(page, (now) => now.renderer.startsWith('web'));
    const names = ['Run', 'Step', 'Reset', 'Undo', 'Redo', 'Drag', 'Select', 'Help'];
    for (const name of names) {
      const box = await boxOf(page.getByRole('button', { name, exact: true }));
      expect(box.x, name).toBeGreaterThanOrEqual(0);
      expect(box.x + box.width, name).toBeLessThanOrEqual(720);
      expect(box.y + box.height, name).toBeLessThanOrEqual(450);
    }
    const view = await boxOf(page.getByRole('application', { name: '3D view' }));
    expect(view.width * view.height).toBeGreaterThan(0.4 * 720 * 450);
    // The hint does not cover the selection bar.
    await page.keyboard.press('b');
    await expect(page.getByRole('button', { name: 'Dismiss hint' })).toBeVisible();
    await page.getByRole('button', { name: /select by/i }).click({ trial: true });
    await page.keyboard.press('v');
    await page.getByRole('button', { name: 'Reset' }).click();
    await waitForState(page, (now) => now.iteration === 0);
    await runToTheEnd(page);

    // Dialogs scroll within the window.
    await page.keyboard.press('?');
    const help = page.getByRole('dialog', { name: 'Mouse and keys' });
    const box = await boxOf(help);
    expect(box.y + box.height).toBeLessThanOrEqual(450);
    await help.getByRole('checkbox').scrollIntoViewIfNeeded();
    await expect(help.getByRole('checkbox')).toBeInViewport();
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Add constraint' }).click();
    const add = page.getByRole('dialog', { name: 'New constraint' });
    await expect(add.getByRole('button', { name: 'Add', exact: true })).toBeInViewport();
    await add.getByRole('radio').last().scrollIntoViewIfNeeded();
    await expect(add.getByRole('radio').last()).toBeInViewport();
  });
});
