// Settings of Build: presets, fields, advice, and what they change.

import { openText } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import {
  openParts,
  outlinesOf,
  overPart,
  partsPanel,
  reportOf,
  setField,
  settingOf,
} from '../sheets.ts';
import { expect, openPage, sceneOf, state, test, waitForState } from '../support.ts';

test.use({ sameDocument: true });

test('what would be too small or would collide is said, with a button that sets it right', async ({
  page,
}) => {
  await openPage(page);
  // Sides of about a foot, 6 mm at 1:50.
  await openText(page, 'roof.obj', `# units: ft\n${wavyGrid(6)}`, 49);
  await openParts(page);
  const panel = partsPanel(page);
  const advised = panel.getByRole('button', { name: /^Scale 1:/ });
  await expect(panel.getByText('edges are')).toContainText('long on average');
  const name = (await advised.textContent()) ?? '';
  await advised.click();
  await expect(advised).toBeHidden();
  await expect(panel.getByLabel('Scale 1 :')).toHaveValue(name.replace('Scale 1:', ''));
  await setField(page, 'Thickness, mm', 4);
  const joint = panel.getByRole('button', { name: /^Joint .* mm$/ });
  await expect(panel.getByText('Panels of 4 mm need a joint')).toBeVisible();
  await joint.last().click();
  await expect(joint).toHaveCount(0);
  await waitForState(page, (now) => (now.build?.joint_mm ?? 0) > 0);
});

test('settings are saved in the scene and can be undone; parts and panels are selected together', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await openParts(page);
  const before = (await sceneOf(page)).build;
  const outlines = await outlinesOf(partsPanel(page), 'cut');
  const choices = { Material: 'Plywood 4 mm', Machine: 'Laser', 'Sheet size': '600 × 400 mm' };
  for (const [name, label] of Object.entries(choices))
    await partsPanel(page).getByLabel(name, { exact: true }).selectOption({ label });
  await waitForState(page, (now) => now.build?.sheet_mm[0] === 600);
  const chosen = {
    material: 'plywood',
    thickness: 4,
    bend: 240,
    kerf: 0.15,
    gap: 1,
    sheet: [600, 400],
  };
  expect((await sceneOf(page)).build).toEqual(chosen);
  for (let step = 0; step < 3; step++) await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(async () => (await sceneOf(page)).build).toEqual(before);
  // Sheets that are drawn again have nothing under the pointer until it moves.
  await expect.poll(() => outlinesOf(partsPanel(page), 'cut')).toEqual(outlines);

  // The part under the pointer, and no other, is marked, selected with its panel, and unmarked.
  for (const part of [3, 5]) {
    const { at, outline } = await overPart(partsPanel(page), part);
    await expect.poll(() => outlinesOf(partsPanel(page), 'pointed')).toEqual([outline]);
    await page.mouse.click(...at);
    await expect.poll(() => outlinesOf(partsPanel(page), 'chosen')).toEqual([outline]);
    expect((await state(page)).selection.faces).toHaveLength(1);
  }
  await partsPanel(page).getByLabel('Material', { exact: true }).hover();
  await expect.poll(() => outlinesOf(partsPanel(page), 'pointed')).toEqual([]);
  await partsPanel(page).getByRole('button', { name: 'Panel flatness' }).click();
  await waitForState(page, (now) => now.selection.faces.length === 1);
  await partsPanel(page).getByLabel('Material', { exact: true }).press('Escape');
  await expect(partsPanel(page)).toBeHidden();
  expect((await state(page)).build).toBe(null);
});

test('every declared setting has a field with its unit, in its group', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', `# units: m\n${wavyGrid(4)}`, 25);
  await openParts(page);
  // Three questions, with the scale; the rest is folded.
  const shown = partsPanel(page).locator('.parts-settings label:visible');
  await expect(shown).toHaveText(['Make', 'Scale 1 :', 'Material', 'Machine', 'Sheet size']);
  for (const group of [/^Parts$/, 'Cutting', 'Limits of the check'])
    await partsPanel(page).locator('summary', { hasText: group }).click();
  await setField(page, 'Kerf, mm', 0.2);
  await setField(page, 'Flatness, mm', 60);
  // Both sides of a sheet are one value of the scene.
  await setField(page, 'Sheet width, mm', 300);
  await setField(page, 'Sheet height, mm', 200);
  const { check } = reportOf(
    await waitForState(page, (now) => now.build?.sheet_mm.join() === '300,200'),
  );
  expect(check.find(({ id }) => id === 'panel_flatness')?.limit).toBe(60);
  const { build } = await sceneOf(page);
  expect(build).toMatchObject({ kerf: 0.2, sheet: [300, 200], limits: { flatness: 60 } });
  await expect(partsPanel(page).getByLabel('Joint, m')).toBeVisible();
  await partsPanel(page).getByLabel('Make').selectOption('paper');
  await expect(partsPanel(page).getByLabel('Tool, mm')).toBeHidden();
  await expect(partsPanel(page).getByLabel('Kerf, mm')).toBeVisible();
  await expect(partsPanel(page).getByLabel('Tabs, mm')).toBeVisible();
});

test('a material, a machine and a sheet of one’s own can be chosen', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', `# units: m\n${wavyGrid(4)}`, 25);
  await openParts(page);
  for (const [name, first] of [
    ['Material', 'Sheet label'],
    ['Machine', 'Kerf, mm'],
    ['Sheet size', 'Sheet width, mm'],
  ]) {
    const choice = partsPanel(page).getByLabel(name, { exact: true });
    await choice.selectOption('Your own');
    await expect(choice).toHaveValue('own');
    await expect(partsPanel(page).getByLabel(first)).toBeFocused();
  }
  await setField(page, 'Kerf, mm', 0.4);
  await expect.poll(async () => (await sceneOf(page)).build).toMatchObject({ kerf: 0.4 });
  // A preset is chosen again by its name.
  const machine = partsPanel(page).getByLabel('Machine', { exact: true });
  await machine.selectOption('Laser');
  await expect.poll(async () => (await sceneOf(page)).build).toMatchObject({ kerf: 0.15 });
  await expect(machine.locator('option:checked')).toHaveText('Laser');
});

test('card that is too thick for creases is scored, and paper is joined by tongues in slots', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'roof.obj', `# units: m\n${wavyGrid(4)}`, 25);
  await openParts(page);
  const panel = partsPanel(page);
  await panel.getByLabel('Make').selectOption('paper');
  await waitForState(page, (now) => now.build?.product === 'paper');
  await setField(page, 'Scale 1 :', 20);
  await (await settingOf(page, 'Cut edges')).selectOption('slots');
  await waitForState(page, (now) => (now.build?.paper?.tongues ?? 0) > 0);
  await expect(panel).toContainText(/\d+ tongues?/);
  await setField(page, 'Thickness, mm', 1);
  await panel.getByRole('button', { name: 'Score the folds' }).click();
  await waitForState(page, (now) => now.build?.paper?.tongues === 0);
  await expect(panel.getByLabel('Folds')).toHaveValue('score');
  await expect(panel.getByRole('button', { name: 'Score the folds' })).toBeHidden();
});

test('node discs join the fins, at a scale at which they have room', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', `# units: m\n${wavyGrid(4)}`, 25);
  await openParts(page);
  await partsPanel(page).getByLabel('Make').selectOption('fins');
  await waitForState(page, (now) => now.build?.product === 'fins');
  await setField(page, 'Scale 1 :', 4);
  const discs = await settingOf(page, 'Node discs, mm');
  // The word that stands in the empty field.
  await discs.fill('auto');
  await discs.press('Tab');
  const built = await waitForState(page, (now) => (now.build?.frame?.placed_discs ?? 0) > 0);
  await expect(discs).toHaveValue('');
  const { frame, placed, parts } = reportOf(built);
  expect(frame?.placed_discs).toBe(25);
  expect(placed).toBe(parts);
  await expect(partsPanel(page)).toContainText('40 fins and 25 node discs on ');
});
