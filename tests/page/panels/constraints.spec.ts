// The list of constraints, the settings below the energies, and handles by numbers and keys.

import type { Page } from '@playwright/test';
import { addConstraint, hidePanels, openGrid, showStep } from '../actions.ts';
import {
  expect,
  positionOf,
  sceneOf,
  screenOf,
  settled,
  state,
  test,
  waitForState,
} from '../support.ts';

const N = 6;
const VERTICES = (N + 1) ** 2;
const MIDDLE = (VERTICES - 1) / 2;

test.use({ sameDocument: true });

test.beforeEach(({ page }) => openGrid(page, N));

const rows = (page: Page) => page.getByRole('list', { name: 'Constraints' }).getByRole('listitem');

test('an edit right after another one reaches the row that it was meant for', async ({ page }) => {
  // The index of a row that the page still shows was that of the next one by then.
  for (const kind of ['Circle', 'Plane', 'Square']) await addConstraint(page, kind, 'each face');
  await showStep(page, 'Shape');
  const parameters = rows(page)
    .first()
    .getByRole('button', { name: /parameters/ });
  await parameters.click();
  const remove = rows(page)
    .first()
    .getByRole('button', { name: /remove/ });
  // In one task, as on a large mesh, where the answer takes longer than the way to the switch.
  await remove.evaluate((button: HTMLElement) => {
    button.click();
    document.querySelector<HTMLElement>('[data-index="1"] [role=switch]')?.click();
  });
  await expect(rows(page)).toHaveCount(2);
  const { constraints } = await sceneOf(page);
  expect(constraints).toMatchObject([{ kind: 'plane', enabled: false }, { kind: 'square' }]);
  expect(constraints[1].enabled ?? true).toBe(true);
});

test.describe('with every row closed', () => {
  // Other tests leave rows open.
  test.use({ sameDocument: false });

  test('rows show their share of the energy, can be duplicated, keep the focus, and select their elements', async ({
    page,
  }) => {
    await addConstraint(page, 'Plane', 'each face');
    await addConstraint(page, 'Circle', 'each face');
    await showStep(page, 'Shape');
    await rows(page)
      .nth(1)
      .getByRole('button', { name: /parameters/ })
      .click();
    // Its last button was cut off.
    const steps = page.getByRole('complementary', { name: 'Steps' });
    expect(await steps.evaluate((all) => all.scrollWidth - all.clientWidth)).toBe(0);
    await rows(page)
      .nth(1)
      .getByRole('button', { name: /parameters/ })
      .click();
    const share = async (row: number) => {
      const text = await rows(page).nth(row).innerText();
      return Number(/(\d+) % of the total energy/.exec(text)?.[1]);
    };
    for (const row of [0, 1])
      await rows(page)
        .nth(row)
        .getByRole('button', { name: /parameters/ })
        .click();
    await expect.poll(() => share(1)).toBeGreaterThan(0);
    expect((await share(0)) + (await share(1))).toBeGreaterThan(97);
    expect((await share(0)) + (await share(1))).toBeLessThan(103);

    const first = rows(page).first();
    await first.getByRole('button', { name: /duplicate/ }).click();
    await expect(rows(page)).toHaveCount(3);
    const { constraints } = await sceneOf(page);
    expect(constraints[0]).toEqual(constraints[1]);
    // Their fields have equal names. The focus used to move to the first of them after a change.
    const weight = rows(page)
      .nth(1)
      .getByRole('spinbutton', { name: /weight/ });
    await weight.fill('3');
    await weight.press('Enter');
    await expect.poll(async () => (await sceneOf(page)).constraints[1].weight).toBe(3);
    await expect(weight).toBeFocused();
    await rows(page)
      .first()
      .getByRole('button', { name: /select what it acts on/ })
      .click();
    await waitForState(page, (now) => now.selection.faces.length === 36);
    await expect(page.getByRole('status')).toHaveText('36 faces selected');
  });
});

test('shapes that do not apply are named with the reason', async ({ page }) => {
  await page.keyboard.press('1');
  await hidePanels(page);
  await page.mouse.click(...(await screenOf(page, MIDDLE)));
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Add constraint' }).click();
  const dialog = page.getByRole('dialog', { name: 'New constraint' });
  const misfits = dialog.getByText(/shapes? do(es)? not fit here/);
  await misfits.click();
  await expect(dialog.getByText(/: it (takes|is for) /).first()).toBeVisible();
});

test('settings come from the declared list, take effect, and can be undone', async ({ page }) => {
  await showStep(page, 'Check');
  await page.getByText('More settings').click();
  const near = page.getByRole('combobox', { name: 'Stay near: kind of value' });
  // By default each vertex of an opened mesh stays near its original position.
  await expect(page.getByText('stay where each vertex was')).toBeVisible();
  await near.selectOption('surface');
  await expect.poll(async () => (await sceneOf(page)).closeness).toBeUndefined();
  await expect(page.getByText('stay near the original')).toBeVisible();
  const boundary = page.getByRole('combobox', { name: /Boundary stays on its curve/ });
  await boundary.selectOption('exactly');
  await expect
    .poll(async () => (await sceneOf(page)).closeness?.boundary)
    .toEqual({
      corners: 45,
      require: 'exact',
    });
  await page.getByRole('combobox', { name: /^Accelerator/ }).selectOption('anderson');
  await expect.poll(async () => (await sceneOf(page)).solver?.accelerator).toBe('anderson');
  // Cotangent weights require triangles: an error is shown, and the field keeps its old value.
  const weighting = page.getByRole('combobox', { name: /^Neighbours count/ });
  await weighting.selectOption('cotangent');
  await expect(page.getByRole('alert')).toContainText('triangle');
  await expect(weighting).toHaveValue('word uniform');
  await page.keyboard.press('Escape');
  for (let step = 0; step < 3; step++) await page.keyboard.press('Control+z');
  await expect(near).toHaveValue('word rest');
  // The scene is updated after the fields.
  await expect.poll(async () => (await sceneOf(page)).closeness).toEqual({ to: 'rest' });
});

test('a second press of Remove does not remove the row that comes in the place of the first', async ({
  page,
}) => {
  await addConstraint(page, 'Plane', 'each face');
  await showStep(page, 'Shape');
  await rows(page)
    .getByRole('button', { name: /parameters/ })
    .click();
  await rows(page)
    .getByRole('button', { name: /duplicate/ })
    .click();
  await expect(rows(page)).toHaveCount(2);
  await rows(page)
    .first()
    .getByRole('button', { name: /remove/ })
    .focus();
  await page.keyboard.press('Enter');
  await expect(rows(page)).toHaveCount(1);
  await page.keyboard.press('Enter');
  await settled(page);
  await expect(rows(page)).toHaveCount(1);
});

test('what is typed in a row goes with the row', async ({ page }) => {
  // It became the weight, or the name, of the row in its place in the model that was opened next.
  await addConstraint(page, 'Plane', 'each face');
  await showStep(page, 'Shape');
  const scene = JSON.stringify({
    ...(await sceneOf(page)),
    constraints: [{ kind: 'circle', on: 'faces' }],
  });
  const openOther = async () => {
    await page.evaluate((text) => window.shapeUp.open(text, 'other.shapeup.json'), scene);
    await expect(rows(page)).toContainText('Circle');
    await settled(page);
    return (await sceneOf(page)).constraints;
  };
  await rows(page)
    .getByRole('spinbutton', { name: /weight/ })
    .selectText();
  await page.keyboard.type('7');
  const untouched = await openOther();
  expect(untouched[0].weight).toBeUndefined();
  await rows(page)
    .getByRole('button', { name: /parameters/ })
    .focus();
  await page.keyboard.press('F2');
  await page.keyboard.type('Mine');
  expect(await openOther()).toEqual(untouched);
});

test('a preset sets all its weights and settings, and shows its assumptions beforehand', async ({
  page,
}) => {
  await showStep(page, 'Check');
  const preset = page.getByRole('combobox', { name: 'Preset' });
  const weights = async () => (await sceneOf(page)).weights;
  await preset.selectOption('Figure 5: smooth surface');
  await expect.poll(weights).toEqual({ shape: 5, close: 10, smooth: 2 });
  expect((await sceneOf(page)).closeness.boundary).toBeDefined();
  await expect(preset).toHaveValue('fig-5');

  await preset.selectOption('Figures 6 and 8: only constraints');
  const warning = page.getByRole('group', { name: /There are no handles/ });
  await expect(warning).toBeVisible();
  await expect(preset).toHaveValue('fig-5');
  await warning.getByRole('button', { name: 'Cancel' }).click();
  await expect(warning).toBeHidden();
  await preset.selectOption('Figures 6 and 8: only constraints');
  await warning.getByRole('button', { name: 'Use anyway' }).click();
  await expect(preset).toHaveValue('fig-6');
  expect((await sceneOf(page)).closeness.to).toBe('none');
  await page.keyboard.press('Control+z');
  await expect(preset).toHaveValue('fig-5');
  // The warning stayed when there was a handle.
  await preset.selectOption('Figures 6 and 8: only constraints');
  await expect(warning).toBeVisible();
  await page.mouse.click(...(await screenOf(page, MIDDLE)));
  await page.keyboard.press('h');
  await waitForState(page, (now) => now.handles.length === 1);
  await expect(warning).toBeHidden();
});

test('the selection is held closer than the rest, and evenly again', async ({ page }) => {
  await hidePanels(page);
  await page.mouse.click(...(await screenOf(page, MIDDLE)));
  await showStep(page, 'Check');
  await page.getByText('More settings').click();
  await page.getByRole('button', { name: 'Closeness of the selection: more' }).click();
  const weights = async () => (await sceneOf(page)).closeness?.weights;
  await expect.poll(weights).toEqual([{ on: { vertices: [MIDDLE] }, weight: 10 }]);
  await expect(page.getByText('1 vertex has its own closeness.')).toBeVisible();
  await page.getByRole('button', { name: 'Same for all' }).click();
  await expect.poll(weights).toBeUndefined();
  // Where nothing is near the original it was said to change, too.
  const preset = page.getByRole('combobox', { name: 'Preset' });
  await preset.selectOption('Figures 6 and 8: only constraints');
  await page.getByRole('button', { name: 'Use anyway' }).click();
  await expect(page.getByText('The weight of Close is 0')).toBeVisible();
  for (const which of ['more', 'less', 'none', 'default'])
    await expect(
      page.getByRole('button', { name: `Closeness of the selection: ${which}` }),
    ).toBeDisabled();
  // Nor did anything say that a boundary needs the weight to stay nearly on its curve.
  const boundary = page.getByRole('combobox', { name: 'Boundary stays on its curve' });
  await expect(page.getByText('not used in this scene')).toBeVisible();
  await boundary.selectOption('nearly');
  await expect(page.getByText('The weight of Close is 0')).toHaveCount(4);
  // It was called unused, although it is the weight of the boundary.
  await expect(page.getByText('stay near the curve of the boundary')).toBeVisible();
});

test('a handle is moved by numbers, fixed, and weighted', async ({ page }) => {
  await addConstraint(page, 'Plane', 'each face');
  await hidePanels(page);
  await page.mouse.click(...(await screenOf(page, MIDDLE)));
  await page.keyboard.press('h');
  await waitForState(page, (now) => now.handles.length === 1);
  const before = await positionOf(page, MIDDLE);
  await showStep(page, 'Shape');
  const height = page.getByRole('spinbutton', { name: 'Target z' });
  await height.fill(String(before[2] + 1));
  await height.press('Enter');
  await expect
    .poll(async () => (await positionOf(page, MIDDLE))[2])
    .toBeGreaterThan(before[2] + 0.5);
  const weight = page.getByRole('spinbutton', { name: 'Weight of the handle' });
  await weight.fill('7');
  await weight.press('Enter');
  await waitForState(page, (now) => now.handles[0].weight === 7);
  await page.getByRole('button', { name: 'Fixed', exact: true }).click();
  await waitForState(page, (now) => now.handles[0].fixed);
  await expect(weight).toBeHidden();
});

test('a handle is moved by keys: picked up, along an axis, dropped, and put back', async ({
  page,
}) => {
  await hidePanels(page);
  await page.mouse.click(...(await screenOf(page, MIDDLE)));
  await page.keyboard.press('h');
  const made = await waitForState(page, (now) => now.handles.length === 1);
  const from = made.handles[0].target;
  await page.keyboard.press('Escape');
  await page.keyboard.press('g');
  await waitForState(page, (now, middle) => now.selection.vertices[0] === middle, MIDDLE);
  await page.getByRole('application', { name: '3D view' }).focus();
  await page.keyboard.press('Enter');
  await page.keyboard.press('z');
  for (let press = 0; press < 4; press++) await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('status')).toHaveText('Handle moved');
  // Half a step would end the move.
  await page.keyboard.press('Enter');
  await expect(page.getByRole('switch', { name: 'Half step', includeHidden: true })).toBeDisabled();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('status')).toHaveText('The handle stays where it was');
  const [{ target }] = (await state(page)).handles;
  expect(target.slice(0, 2)).toEqual(from.slice(0, 2));
  expect(target[2]).toBeGreaterThan(from[2]);
  await page.keyboard.press('Enter');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Escape');
  await expect.poll(async () => (await state(page)).handles[0].target).toEqual(target);
});

test('Alt-drag makes a handle and moves it; Shift keeps its height', async ({ page }) => {
  await hidePanels(page);
  const [x, y] = await screenOf(page, MIDDLE);
  await page.keyboard.down('Alt');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.keyboard.up('Alt');
  await waitForState(page, (now) => now.handles.length === 1);
  const { handles } = await state(page);
  const from = handles[0].target;
  await page.keyboard.down('Shift');
  await page.mouse.move(x + 40, y - 10, { steps: 4 });
  await page.mouse.up();
  await page.keyboard.up('Shift');
  const moved = await waitForState(
    page,
    (now, before) => now.handles[0].target[0] !== before[0],
    from,
  );
  expect(moved.handles[0].vertex).toBe(MIDDLE);
  expect(moved.handles[0].target[2]).toBe(from[2]);
});
