// The layout in both windows, the help, and what assistive technology reads.

import { openText, showStep, tool } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { boxOf, expect, openPage, test, windowOf } from '../support.ts';

const NAMES = ['Run', 'Step', 'Reset', 'Undo', 'Redo'];

test('nothing is cut off, and the view has at least half of the window', async ({ page }) => {
  await openPage(page);
  const { width, height } = windowOf(page);
  for (const name of NAMES) {
    const box = await boxOf(page.getByRole('button', { name }));
    expect(box.x, name).toBeGreaterThanOrEqual(0);
    expect(box.x + box.width, name).toBeLessThanOrEqual(width);
    expect(box.y + box.height, name).toBeLessThanOrEqual(height);
  }
  const ends = await page
    .getByRole('banner')
    .getByRole('button')
    .evaluateAll((buttons) => buttons.map((button) => button.getBoundingClientRect().right));
  expect(Math.max(...ends)).toBeLessThanOrEqual(width);
  const view = page.getByRole('application', { name: '3D view' });
  const area = async () => {
    const box = await boxOf(view);
    return (box.width * box.height) / (width * height);
  };
  expect(await area()).toBeGreaterThanOrEqual(0.5);
  const tab = page.getByRole('tab', { name: 'Shape' });
  if (await tab.isVisible()) {
    await tab.click();
    await expect(page.getByRole('complementary', { name: 'Steps' })).toBeVisible();
    expect(await area()).toBeGreaterThanOrEqual(0.5);
  }
  const scrolls = await page.evaluate(() => {
    const { scrollWidth, scrollHeight } = document.documentElement;
    return scrollWidth > innerWidth || scrollHeight > innerHeight;
  });
  expect(scrolls).toBe(false);
});

test('every control has a name, and the help lists the keys', async ({ page }) => {
  await openPage(page);
  const nameless = await page.evaluate(() =>
    [
      ...document.querySelectorAll<HTMLButtonElement | HTMLInputElement | HTMLSelectElement>(
        'button, input, select',
      ),
    ]
      .filter((control) => {
        const label = control.getAttribute('aria-label') ?? control.labels?.[0]?.textContent;
        return !(label || control.textContent).trim();
      })
      .map((control) => control.outerHTML),
  );
  expect(nameless).toEqual([]);
  await expect(page.getByRole('heading', { level: 1 })).toHaveCount(1);
  await expect(page.getByRole('status')).toHaveCount(1);
  await expect(page.getByRole('alert')).toHaveCount(1);

  await tool(page, 'Help');
  const help = page.getByRole('dialog', { name: 'Mouse and keys' });
  await expect(help).toBeVisible();
  await expect(help.getByText('Run or pause')).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(help).toBeHidden();
});

test('the dialog of a new constraint is beside the view, with all its choices visible', async ({
  page,
}, { project }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(6), 49);
  const sizes = [
    { width: 1440, height: 900 },
    { width: 1024, height: 768 },
  ];
  for (const size of project.name === 'phone' ? [{ width: 390, height: 844 }] : sizes) {
    await page.setViewportSize(size);
    await showStep(page, 'Shape');
    await page.getByRole('button', { name: 'Add constraint' }).click();
    const dialog = page.getByRole('dialog', { name: 'New constraint' });
    await expect(dialog.getByRole('button', { name: 'Add', exact: true })).toBeEnabled();
    const view = await boxOf(page.getByRole('application', { name: '3D view' }));
    const dock = await boxOf(dialog);
    const isApart = dock.x + dock.width <= view.x || view.y + view.height <= dock.y;
    expect(isApart, `beside the view at ${size.width}`).toBe(true);
    expect(view.height).toBeGreaterThan(size.height * 0.45);
    const { width, height } = await dialog.evaluate((one) => ({
      width: one.scrollWidth - one.clientWidth,
      height: one.scrollHeight - one.clientHeight,
    }));
    expect([width, height], 'it does not scroll').toEqual([0, 0]);
    for (const chosen of await dialog.getByRole('radio', { checked: true }).all())
      await expect(chosen).toBeInViewport({ ratio: 0.9 });
    await expect(dialog.getByRole('spinbutton', { name: 'Weight' })).toBeInViewport({ ratio: 1 });
    for (const name of ['Add', 'Add and run'])
      await expect(dialog.getByRole('button', { name, exact: true })).toBeInViewport({ ratio: 1 });
    await dialog.getByRole('button', { name: 'Close' }).click();
  }
});
