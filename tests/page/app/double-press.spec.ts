// Two quick presses on a control open one dialog, although some are prepared first.

import { openText, tool } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { drawn, expect, openPage, test } from '../support.ts';

const N = 4;

/** What is pressed, and the dialog that it opens. */
const DIALOGS = [
  ['button', 'Present', 'Presentation'],
  ['button', 'Share', 'Share'],
  ['button', 'More formats', 'More formats'],
  ['button', 'Write a lesson', 'Lesson'],
  ['button', 'Refine', 'Refine'],
  ['button', 'Edit mesh', 'Edit mesh'],
  ['menuitem', 'New mesh', 'New mesh'],
] as const;

test('two quick presses open one dialog, and a press after it opens it again', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(N), (N + 1) ** 2);
  const open = page.locator('dialog:modal');
  for (const [role, name, title] of DIALOGS) {
    // The menu of the examples is closed.
    const exact = role === 'button';
    const control = page.getByRole(role, { name, exact, includeHidden: true }).first();
    for (const presses of [2, 1]) {
      await control.evaluate((element: HTMLElement, times) => {
        for (let time = 0; time < times; time++) element.click();
      }, presses);
      await expect(page.getByRole('dialog', { name: title, exact: true })).toBeVisible();
      // By now a second one would be open.
      await drawn(page);
      await expect(open, title).toHaveCount(1);
      await open.getByRole('button', { name: 'Close' }).click();
      await expect(open).toHaveCount(0);
    }
  }
});

test('two quick presses on a format make one file', async ({ page }) => {
  // Each made one; of a film, both turned the same view.
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(N), (N + 1) ** 2);
  const files: string[] = [];
  page.on('download', (download) => files.push(download.suggestedFilename()));
  const dialog = page.getByRole('dialog', { name: 'More formats' });
  for (const count of [1, 2]) {
    await tool(page, 'More formats');
    const format = dialog.getByRole('button', { name: /^Scene/ });
    await format.evaluate((element: HTMLElement) => {
      for (let time = 0; time < 2; time++) element.click();
    });
    await expect(dialog).toBeHidden();
    await drawn(page);
    expect(files).toHaveLength(count);
  }
});
