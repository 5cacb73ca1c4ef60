// Every action can be undone, in one step each.

import { addConstraint, openText, runToTheEnd, showStep, tool } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import {
  dragVertex,
  everything,
  expect,
  known,
  openPage,
  state,
  test,
  waitForState,
} from '../support.ts';

test.use({ sameDocument: true });

test('all actions are undone step by step to the start, and redone', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  const start = await everything(page);

  await addConstraint(page, 'Plane', 'each face');
  await showStep(page, 'Shape');
  await page.getByRole('combobox', { name: 'Unit' }).selectOption('cm');
  await page.getByRole('combobox', { name: 'Up axis' }).selectOption('y');
  await page.getByRole('switch', { name: /^Plane/ }).click();
  await expect(page.getByRole('switch', { name: /^Plane/ })).not.toBeChecked();
  await page.getByRole('switch', { name: /^Plane/ }).click();
  await expect(page.getByRole('switch', { name: /^Plane/ })).toBeChecked();
  const run = await runToTheEnd(page);
  await tool(page, 'Step');
  await tool(page, 'Reset');
  await waitForState(page, (now) => now.iteration === 0);
  const end = await everything(page);

  const undo = page.getByRole('button', { name: 'Undo' });
  const names = [];
  while (await undo.isEnabled()) {
    const title = known(await undo.getAttribute('title'));
    names.unshift(title.replace(/ \(.*/, ''));
    await page.keyboard.press('Control+z');
    await expect(undo).not.toHaveAttribute('title', title);
  }
  expect(names).toEqual([
    'Undo: Add plane',
    'Undo: Change unit',
    'Undo: Change up axis',
    'Undo: Switch off plane',
    'Undo: Switch on plane',
    `Undo: Run, ${run.iteration} iterations`,
    'Undo: Run, 1 iteration',
    'Undo: Reset',
  ]);
  await expect.poll(() => everything(page)).toEqual(start);
  const redo = page.getByRole('button', { name: 'Redo' });
  while (await redo.isEnabled()) {
    const title = known(await redo.getAttribute('title'));
    await page.keyboard.press('Control+y');
    await expect(redo).not.toHaveAttribute('title', title);
  }
  await expect.poll(() => everything(page)).toEqual(end);
});

test('a drag is one step, and a cancelled drag is none', async ({ page }) => {
  await openPage(page);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
  const before = await everything(page);
  const soft = known((await state(page)).handles.find((handle) => !handle.fixed));
  await dragVertex(page, soft.vertex, [10, -20]);
  const undo = page.getByRole('button', { name: 'Undo' });
  await expect(undo).toHaveAttribute('title', /Move handle/);
  await waitForState(page, (now) => now.iteration > 0);
  await page.keyboard.press('Control+z');
  await expect(undo).toBeDisabled();
  await expect.poll(() => everything(page)).toEqual(before);

  const [x, y] = known(await page.evaluate((vertex) => window.shapeUp.screen(vertex), soft.vertex));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 10, y - 20, { steps: 4 });
  await waitForState(page, (now) => now.iteration > 0);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await expect(undo).toBeDisabled();
  await expect.poll(() => everything(page)).toEqual(before);
});
