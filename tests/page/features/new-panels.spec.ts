// From a roof of triangles to circular panels along its lines of curvature.

import type { Page } from '@playwright/test';
import { hidePanels, openText, showStep, tool } from '../actions.ts';
import { barrel, vault, wavyGrid } from '../meshes.ts';
import { openParts, partsPanel } from '../sheets.ts';
import { expect, openPage, screenOf, settled, state, test, waitForState } from '../support.ts';

test.use({ sameDocument: true });

const N = 14;
const VERTICES = (N + 1) ** 2;
const SENTENCE =
  /^\d+ panels, (\d+|no) irregular points?, edges [\d.]+° off the lines of curvature\. The mesh will then (not )?move /;

const offer = (page: Page) => page.getByRole('group', { name: 'Panels', exact: true });
const card = (page: Page) => page.getByRole('region', { name: 'New panels' });
const use = (page: Page) => card(page).getByRole('button', { name: 'Use these panels' });

test('a roof of triangles gets panels along its lines of curvature, which become circular', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'vault.obj', vault(N), VERTICES);
  await offer(page).getByRole('button', { name: 'New panels along the curvature' }).click();
  await expect(card(page).getByText(SENTENCE)).toBeVisible();
  await expect(use(page)).toBeEnabled();

  // Fewer, larger panels: the side follows their number.
  const side = async () => Number(await card(page).getByLabel('Side').inputValue());
  const before = await side();
  await card(page).getByLabel('Panels', { exact: true }).fill('64');
  await card(page).getByLabel('Panels', { exact: true }).press('Enter');
  await expect.poll(side).toBeGreaterThan(before);
  await expect(use(page)).toBeEnabled();
  // Nothing has changed until they are used.
  await settled(page);
  expect((await state(page)).vertices).toBe(VERTICES);

  await card(page).getByLabel('Then').selectOption('Make panels circular');
  await use(page).click();
  await expect(card(page)).toBeHidden();
  const solved = await waitForState(page, (now) => !now.running && now.exact?.met);
  expect(solved.faces).toBeGreaterThan(50);
  expect(solved.faces).toBeLessThan(80);
  expect(solved.constraints).toEqual({ circle: solved.faces });
  await expect(offer(page)).toContainText(
    /All \d+ panels are circular within .* They stay within .* of the surface that they were laid out on\./,
  );
  // They are on sheets, one part for each.
  const build = await openParts(page);
  expect(build.panels).toBe(solved.faces);
  expect(build.sheets).toBeGreaterThan(0);
  await expect(partsPanel(page).getByRole('img')).toHaveCount(build.sheets);
  await page.getByRole('application', { name: '3D view' }).focus();

  // One step each: the circles, then the panels.
  await page.keyboard.press('Control+z');
  await waitForState(page, (now) => Object.keys(now.constraints).length === 0);
  await page.keyboard.press('Control+z');
  await waitForState(page, (now, vertices) => now.vertices === vertices, VERTICES);
  await page.keyboard.press('Control+Shift+z');
  await waitForState(page, (now, vertices) => now.vertices !== vertices, VERTICES);
});

test('a refused size changes nothing, and Escape leaves the mesh as it was', async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(6), 49);
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'New panels', exact: true }).click();
  await expect(use(page)).toBeEnabled();
  await card(page).getByLabel('Side').fill('1000');
  await card(page).getByLabel('Side').press('Enter');
  await expect(card(page).getByText(/^Not possible: .*too large for the surface/)).toBeVisible();
  await expect(use(page)).toBeDisabled();
  // The refusal has a place, which it shows.
  await card(page)
    .getByRole('button', { name: /^Not possible: / })
    .click();
  await page.keyboard.press('Escape');
  await expect(card(page)).toBeHidden();
  await settled(page);
  expect((await state(page)).vertices).toBe(49);
  await showStep(page, 'Check');
  await expect(page.getByRole('checkbox', { name: 'Edges', exact: true })).toBeChecked();
});

test('a number typed while panels are laid out stays, and another card takes the place', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'vault.obj', vault(N), VERTICES);
  await offer(page).getByRole('button', { name: 'New panels along the curvature' }).click();
  const panels = card(page).getByLabel('Panels', { exact: true });
  await expect(panels).toBeFocused();
  // The first layout used to write its number between the digits.
  await panels.pressSequentially('64', { delay: 300 });
  await panels.press('Enter');
  await expect(card(page).getByText(/^(5|6|7)\d panels, /)).toBeVisible();
  // Both cards draw lines on the surface.
  await tool(page, 'Curvature');
  await expect(card(page)).toBeHidden();
  const curvature = page.getByRole('region', { name: 'Curvature' });
  await expect(curvature).toBeVisible();
  await curvature.getByRole('button', { name: 'Close curvature' }).click();
});

test('a wish that takes long says what it does, and its Cancel brings the last panels back', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'vault.obj', vault(60), 61 * 61);
  await offer(page).getByRole('button', { name: 'New panels along the curvature' }).click();
  await expect(use(page)).toBeEnabled();
  const panels = card(page).getByLabel('Panels', { exact: true });
  const [count, said] = [await panels.inputValue(), card(page).getByText(SENTENCE)];
  const words = await said.textContent();
  await panels.fill('9000');
  await panels.press('Enter');
  const cancel = card(page).getByRole('button', { name: 'Cancel' });
  await cancel.click();
  await expect(cancel).toBeHidden();
  await expect(panels).toHaveValue(count);
  await expect(said).toHaveText(words ?? '');
  await expect(page.getByRole('alert')).toBeEmpty();
  // The next wish is answered by another worker.
  await panels.fill('200');
  await panels.press('Enter');
  await expect(card(page).getByText(/^(19|20|21)\d panels, /)).toBeVisible();
  await use(page).click();
  await expect(card(page)).toBeHidden();
});

/** The vault with one triangle beside it. */
const withTriangle = (n: number) =>
  `${vault(n)}v 30 0 0\nv 31 0 0\nv 30 1 0\nf ${[1, 2, 3].map((k) => (n + 1) ** 2 + k).join(' ')}\n`;

test('both choices at the boundary are forecast, and the automatic one can be chosen again', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'vault.obj', vault(N), VERTICES);
  await offer(page).getByRole('button', { name: 'New panels along the curvature' }).click();
  const choice = card(page).getByLabel('Boundary');
  await expect(choice).toHaveValue('');
  const pattern = /^\d+ panels, will move about [\d.]+/;
  const forecasts = card(page).getByRole('definition');
  await expect(forecasts.nth(0)).toHaveText(pattern);
  await expect(forecasts.nth(1)).toHaveText(pattern);
  const follows = await forecasts.nth(0).textContent();
  await choice.selectOption('Panels are cut at it');
  await expect(card(page).locator('[aria-current=true]')).toContainText(/^Cut/);
  await choice.selectOption('Automatic');
  await expect(card(page).locator('[aria-current=true]')).toContainText(/^Followed/);
  await expect(forecasts.nth(0)).toHaveText(follows ?? '');
});

test('a small part stays, is said to, and its place comes into view', async ({ page }) => {
  await openPage(page);
  await openText(page, 'vault.obj', withTriangle(N), VERTICES + 3);
  await offer(page).getByRole('button', { name: 'New panels along the curvature' }).click();
  const note = card(page).getByRole('button', { name: '1 small part stays as it is.' });
  await expect(note).toBeVisible();
  const far = async () => {
    const at = await Promise.all([screenOf(page, VERTICES), screenOf(page, VERTICES + 1)]);
    return Math.hypot(at[0][0] - at[1][0], at[0][1] - at[1][1]);
  };
  const before = await far();
  await note.click();
  await expect.poll(far).toBeGreaterThan(2 * before);
  await use(page).click();
  await expect(card(page)).toBeHidden();
  await waitForState(page, (now, vertices) => now.vertices !== vertices, VERTICES + 3);
});

test('selected faces stay as they are, if that is asked', async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(8), 81);
  // The face with the corners 40 and 50.
  await hidePanels(page);
  await page.keyboard.press('3');
  const [from, to] = await Promise.all([screenOf(page, 40), screenOf(page, 50)]);
  await page.mouse.click((from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
  await expect(page.getByRole('status')).toHaveText('1 face selected');
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'New panels', exact: true }).click();
  await expect(use(page)).toBeEnabled();
  await card(page).getByLabel('The selected face stays as it is').check();
  await expect(card(page).getByText(/^1 selected face stays, /)).toBeVisible();
  await use(page).click();
  await expect(card(page)).toBeHidden();
  const scene = await waitForState(page, (now) => now.vertices !== 81);
  expect(scene.faces).toBeGreaterThan(40);
});

test('panels are laid out anew while a slider is dragged', async ({ page }) => {
  await openPage(page);
  await openText(page, 'vault.obj', vault(N), VERTICES);
  await offer(page).getByRole('button', { name: 'New panels along the curvature' }).click();
  for (const [low, high] of [
    ['Fewer irregular points', 'moves less'],
    ['Small panels where it curves', 'even sizes'],
  ]) {
    const slider = card(page).getByRole('slider', { name: `${low} to ${high}` });
    const said = card(page).getByText(SENTENCE);
    await expect(said).toBeVisible();
    const before = await said.textContent();
    const { x, y, width, height } = (await slider.boundingBox())!;
    const at = async (share: number) => {
      await page.mouse.move(x + share * width, y + height / 2, { steps: 4 });
    };
    await at(Number(await slider.inputValue()));
    await page.mouse.down();
    await at(low.startsWith('Fewer') ? 0.01 : 0.99);
    // The button is still down.
    await expect(said).not.toHaveText(before ?? '');
    await expect(use(page)).toBeEnabled();
    await page.mouse.up();
  }
});

test('new panels are the blue button where edges are off the lines of curvature', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'barrel.obj', barrel(12, 15), 169);
  const newPanels = offer(page).getByRole('button', { name: 'New panels along the curvature' });
  const accent = await page.evaluate(() => {
    const probe = document.body.appendChild(document.createElement('i'));
    probe.style.setProperty('color', 'var(--accent)');
    const { color } = getComputedStyle(probe);
    probe.remove();
    return color;
  });
  await expect(newPanels).toHaveCSS('background-color', accent);
  const circular = offer(page).getByRole('button', { name: 'Make panels circular' });
  await expect(circular).not.toHaveCSS('background-color', accent);
  // Along the lines of curvature they are not offered.
  await openText(page, 'along.obj', barrel(12, 0), 169);
  await expect(offer(page).getByText(/^This mesh will not move/)).toBeVisible();
  await expect(newPanels).toBeHidden();
});

test('the dialog for changes of the mesh leads to new panels', async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(6), 49);
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Edit mesh', exact: true }).click();
  const dialog = page.getByRole('dialog', { name: 'Edit mesh' });
  await dialog.getByRole('button', { name: 'New panels' }).click();
  await expect(dialog).toBeHidden();
  await expect(use(page)).toBeEnabled();
});

test('new panels are not offered on a flat plate', async ({ page }) => {
  await openPage(page);
  const flat = vault(N).replace(/^(v \S+ \S+) \S+$/gm, '$1 0');
  await openText(page, 'plate.obj', flat, VERTICES);
  await expect(offer(page).getByText(/^All panels are triangles/)).toBeVisible();
  await expect(
    offer(page).getByRole('button', { name: 'New panels along the curvature' }),
  ).toBeHidden();
});
