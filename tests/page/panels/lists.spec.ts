// Lists in words and numbers: names of constraints, the worst elements, the log, and verdicts.

import type { Page } from '@playwright/test';
import { addConstraint, openText, runToTheEnd, showStep } from '../actions.ts';
import { file, wavyGrid } from '../meshes.ts';
import { expect, known, openPage, sceneOf, state, test, waitForState } from '../support.ts';

test.use({ sameDocument: true });

const N = 6;
const VERTICES = (N + 1) ** 2;

test.beforeEach(async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), VERTICES);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
});

/** Brings a tab of the analysis to the front. */
async function showTab(page: Page, name: string) {
  await showStep(page, 'Check');
  const tab = page.getByRole('tablist', { name: 'Analysis' }).getByRole('tab', { name });
  await tab.click();
  await expect(page.getByRole('tabpanel', { name })).toBeVisible();
}

test('a constraint is renamed in its row, and the name is saved', async ({ page }) => {
  await addConstraint(page, 'Plane', 'each face');
  await showStep(page, 'Shape');
  const row = page.getByRole('list', { name: 'Constraints' }).getByRole('listitem');
  const field = page.getByRole('textbox', { name: 'Name of the constraint' });
  const name = async () => (await sceneOf(page)).constraints[0].name;
  await row.getByRole('button', { name: /parameters/ }).focus();
  await page.keyboard.press('F2');
  await expect(field).toBeFocused();
  await page.keyboard.type('Not this');
  await page.keyboard.press('Escape');
  await expect(field).toBeHidden();
  expect(await name()).toBeUndefined();

  await page.keyboard.press('F2');
  await expect(field).toBeFocused();
  await page.keyboard.type('Skylight');
  await page.keyboard.press('Enter');
  await expect.poll(name).toBe('Skylight');
  await expect(row).toContainText('Plane, each face');
  const opener = row.getByRole('button', { name: /^Skylight on each face: parameters/ });
  await expect(opener).toBeFocused();

  await opener.dblclick();
  await expect(field).toHaveValue('Skylight');
  await field.fill('');
  await page.keyboard.press('Enter');
  await expect.poll(name).toBeUndefined();
  await page.keyboard.press('Control+z');
  await expect(page.getByRole('status')).toHaveText('Undid: Rename plane');
  expect(await name()).toBe('Skylight');
  const text = JSON.stringify(await sceneOf(page));
  await openText(page, 'named.shapeup.json', text, VERTICES);
  await expect(row).toContainText('Skylight');
});

test('the worst elements are in a table that selects them, also by keyboard', async ({ page }) => {
  await addConstraint(page, 'Plane', 'each face');
  await showTab(page, 'Worst');
  const table = page.getByRole('table', { name: 'Worst elements' });
  const first = table.getByRole('button').first();
  await expect(table.getByRole('row')).toHaveCount(21);
  await expect(table.getByRole('row').nth(1)).toContainText('Plane');
  const face = Number(known(/face (\d+)/.exec(await first.innerText()))[1]);
  await first.focus();
  await page.keyboard.press('ArrowDown');
  await expect(table.getByRole('button').nth(1)).toBeFocused();
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Enter');
  await waitForState(
    page,
    (now, one) => now.selection.faces.length === 1 && now.selection.faces[0] === one,
    face,
  );
  await expect(page.getByRole('status')).toHaveText('1 face selected');

  // Sorting by constraint gives the same order here; after the run no error is large.
  const choice = page.getByRole('combobox', { name: 'Worst by' });
  await choice.selectOption({ label: 'Constraint: Plane on each face' });
  await expect(first).toHaveText(`face ${face}`);
  const before = known((await state(page)).planarity).max_distance;
  await runToTheEnd(page);
  await showStep(page, 'Check');
  const cell = table.getByRole('row').nth(1).getByRole('cell').last();
  await expect(cell).toHaveText(/ mm$/);
  const metres = async () => Number.parseFloat(await cell.innerText()) / 1000;
  await expect.poll(metres).toBeLessThan(before / 10);
});

test('the report on a file selects the elements of a problem, and the log has the messages', async ({
  page,
  context,
}) => {
  const odd = `${wavyGrid(N)}v 9 9 9\nwiggle 3\n`;
  await openText(page, 'odd.obj', odd, VERTICES + 1);
  await showStep(page, 'Open');
  const report = page.locator('#import-report');
  await expect(report).toContainText('1 unknown statement ignored');
  await report.getByRole('button', { name: /^Select: 1 unused vertex/ }).click();
  await waitForState(
    page,
    (now, one) => now.selection.vertices.length === 1 && now.selection.vertices[0] === one,
    VERTICES,
  );
  await showStep(page, 'Check');
  await page.getByRole('tab', { name: 'Log' }).click();
  const log = page.getByRole('tabpanel', { name: 'Log' });
  const messages = log.getByRole('list', { name: 'Messages' });
  await expect(messages).toContainText('Opened odd.obj');
  await page.evaluate(() => window.shapeUp.open('v 1 2', 'broken.xyz').catch(() => {}));
  await expect(messages.getByRole('listitem').first()).toContainText('broken.xyz');

  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await log.getByRole('button', { name: 'Copy as text' }).click();
  await expect(log).toContainText('Copied');
  const text = await page.evaluate(() => navigator.clipboard.readText());
  expect(text).toMatch(/\d\d:\d\d.*Error: broken\.xyz/);
});

test('faces without area are reported and can be selected', async ({ page }) => {
  const flat = `${wavyGrid(N)}v 0 0 0\nv 1 0 0\nv 2 0 0\nf -3 -2 -1\n`;
  await openText(page, 'flat.obj', flat, VERTICES + 3);
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('1 face has zero size; it is kept but not coloured.');
  await alert.getByRole('button', { name: 'Select' }).click();
  await waitForState(page, (now) => now.selection.faces[0] === 36);
});

test('a message with an offer stays beside one that offers something else', async ({ page }) => {
  // What was joined could not be undone: the message came and went at once.
  // Squares with vertices of their own, and a face without area.
  const square = (x: number) =>
    `v ${x} 0 0\nv ${x + 1} 0 0\nv ${x + 1} 1 0\nv ${x} 1 0\nf -4 -3 -2 -1\n`;
  const loose = `${square(0)}${square(1)}${square(2)}v 5 0 0\nv 6 0 0\nv 7 0 0\nf -3 -2 -1\n`;
  await page.getByLabel('Open file').setInputFiles(file('loose.obj', loose));
  const alert = page.getByRole('alert');
  await expect(alert.getByRole('button', { name: 'Select' })).toBeVisible();
  await expect(alert.getByRole('button', { name: 'Undo' })).toBeVisible();
  await alert.getByRole('button', { name: 'Select' }).click();
  await expect(alert.getByRole('paragraph')).toHaveText(/^Joined vertices/);
  await page.getByLabel('Open file').setInputFiles(file('grid.obj', wavyGrid(N)));
  await expect(alert).toBeEmpty();
});

test('a run reports that all is within tolerance, or the worst element and what reduces its error', async ({
  page,
}) => {
  await addConstraint(page, 'Plane', 'each face');
  const row = page.getByRole('list', { name: 'Constraints' }).getByRole('listitem');
  const within = async (value: string) => {
    await page.getByLabel('Tolerance').fill(value);
    await page.getByLabel('Tolerance').press('Enter');
  };
  await within('50');
  await runToTheEnd(page);
  const verdict = page.getByRole('group', { name: 'Verdict' });
  await expect(verdict).toContainText('All constraints are satisfied within 50 mm.');
  await expect(row).toContainText('within tolerance');
  await page.getByRole('application', { name: '3D view' }).focus();
  await page.keyboard.press('Escape');
  await expect(verdict).toBeHidden();
  await within('0.001');
  await expect(row).toContainText('beyond tolerance');

  // The four corners of a face are fixed at positions that no plane contains.
  const text = await sceneOf(page);
  text.handles = [
    { vertices: [0], targets: [[0, 0, 3]], fixed: true },
    { vertices: [1], targets: [[1, 0, -3]], fixed: true },
    { vertices: [N + 1], targets: [[0, 1, -3]], fixed: true },
    { vertices: [N + 2], targets: [[1, 1, 3]], fixed: true },
  ];
  await openText(page, 'hard.shapeup.json', JSON.stringify(text), VERTICES);
  await runToTheEnd(page);
  await expect(verdict).toContainText(
    'The run has ended, and some constraints are beyond the tolerance of 0.001 mm. Worst: Plane on face 0.',
  );
  await verdict.getByRole('button', { name: 'Show it' }).click();
  await waitForState(page, (now) => now.selection.faces[0] === 0);
  await expect(verdict).toBeHidden();
  await page.getByRole('button', { name: 'Reset' }).click();
  const before = await worst(page);
  await runToTheEnd(page);
  await verdict.getByRole('button', { name: /^Remove the handles: / }).click();
  await waitForState(page, (now) => now.handles.length === 0 && now.converged && !now.running);
  // During a run the numbers are updated a few times a second.
  await expect.poll(() => worst(page)).toBeLessThan(0.5 * before);
});

/** The worst distance in the first row of constraints, in the unit of the mesh. */
async function worst(page: Page) {
  const text = await page
    .getByText(/^worst \d/)
    .first()
    .textContent();
  return Number.parseFloat(known(text?.match(/\d[\d.e-]*/))[0]);
}

test('the worst elements of a mesh are gone once another one is open', async ({ page }) => {
  // Until the table was in sight and the solver had answered, its rows selected faces by their number
  // in the mesh before.
  const rows = page.locator('.worst-elements tbody tr');
  await addConstraint(page, 'Plane', 'each face');
  await showTab(page, 'Worst');
  await expect(rows).not.toHaveCount(0);
  await showTab(page, 'Log');
  await openText(page, 'small.obj', wavyGrid(2), 9);
  await expect(rows).toHaveCount(0);
});

test('the worst elements stay those of a constraint when one before it is removed', async ({
  page,
}) => {
  // The choice was the place in the list: it was another constraint then.
  await addConstraint(page, 'Plane', 'each face');
  await addConstraint(page, 'Circle', 'each face');
  await addConstraint(page, 'Square', 'each face');
  await showTab(page, 'Worst');
  const choice = page.getByRole('combobox', { name: 'Worst by' });
  await choice.selectOption({ label: 'Constraint: Circle on each face' });
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: /^Plane.*: parameters/ }).click();
  await page.getByRole('button', { name: /^Plane.*: remove/ }).click();
  await expect(choice.locator('option')).toHaveCount(3);
  await expect(choice.locator('option:checked')).toHaveText('Constraint: Circle on each face');
});
