// Parts of the page that cannot be fetched at first: an error is shown, and they load at the next
// attempt.

import type { Page } from '@playwright/test';
import { addConstraint, hidePanels, openText, showPanel } from '../actions.ts';
import { file, wavyGrid } from '../meshes.ts';
import { dragVertex, expect, openPage, screenOf, test, waitForState } from '../support.ts';

const N = 6;
const VERTICES = (N + 1) ** 2;
const MIDDLE = (VERTICES - 1) / 2;
const WORDS = 'A part of the page could not be fetched. Check the network.';

const alert = (page: Page) => page.getByRole('alert');

test.beforeEach(async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), VERTICES);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
});

/** Expects no complaints other than those about the aborted requests. */
function expectOnlyAborted(complaints: string[]) {
  expect(complaints.filter((text) => !text.includes('net::ERR_FAILED'))).toEqual([]);
  complaints.length = 0;
}

test('the fields of a handle load at the next selection', async ({ page, complaints }) => {
  const part = '**/handle-details-*.js';
  await page.route(part, (route) => route.abort());
  await hidePanels(page);
  await page.mouse.click(...(await screenOf(page, MIDDLE)));
  await page.keyboard.press('h');
  await expect(alert(page)).toHaveText(WORDS);
  await page.unroute(part);
  await page.keyboard.press('Escape');
  await waitForState(page, (now) => now.selection.vertices.length === 0);
  await page.keyboard.press('g');
  await showPanel(page, 'Model');
  await expect(page.getByRole('group', { name: 'Selected handles' })).toBeVisible();
  expectOnlyAborted(complaints);
});

test('a constraint is renamed at the next attempt', async ({ page, complaints }) => {
  const part = '**/rename-*.js';
  await page.route(part, (route) => route.abort());
  await addConstraint(page, 'Plane', 'each face');
  await showPanel(page, 'Model');
  const row = page.getByRole('list', { name: 'Constraints' }).getByRole('listitem');
  const field = page.getByRole('textbox', { name: 'Name of the constraint' });
  await row.getByRole('button', { name: /parameters/ }).focus();
  await page.keyboard.press('F2');
  await expect(alert(page)).toHaveText(WORDS);
  await page.unroute(part);
  await page.keyboard.press('F2');
  await expect(field).toBeFocused();
  expectOnlyAborted(complaints);
});

test('more settings load when they are opened again', async ({ page, complaints }) => {
  const part = '**/settings-*.js';
  await page.route(part, (route) => route.abort());
  await showPanel(page, 'Energies and display');
  await page.getByText('More settings').click();
  await expect(alert(page)).toHaveText(WORDS);
  await page.unroute(part);
  await page.getByText('More settings').click();
  await page.getByText('More settings').click();
  await expect(page.getByRole('group', { name: 'Closeness of the selection' })).toBeVisible();
  expectOnlyAborted(complaints);
});

test('a file is refused with its reason, even without the offer of other files', async ({
  page,
  complaints,
}) => {
  await page.route('**/missing-files-*.js', (route) => route.abort());
  await page.getByLabel('Open file').setInputFiles(file('bad.obj', 'hello\n'));
  await expect(alert(page)).toContainText('bad.obj');
  expectOnlyAborted(complaints);
});

test('the label of a drag comes at the next drag', async ({ page, complaints }) => {
  const part = '**/drag-label-*.js';
  await page.route(part, (route) => route.abort());
  await hidePanels(page);
  await page.mouse.click(...(await screenOf(page, MIDDLE)));
  await page.keyboard.press('h');
  await waitForState(page, (now) => now.handles.length === 1);
  await dragVertex(page, MIDDLE, [60, 0]);
  await expect(alert(page)).toHaveText(WORDS);
  await page.unroute(part);
  const [x, y] = await screenOf(page, MIDDLE);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 60, y, { steps: 5 });
  await expect(page.locator('#moved')).toHaveText(/ m$/);
  await page.mouse.up();
  expectOnlyAborted(complaints);
});
