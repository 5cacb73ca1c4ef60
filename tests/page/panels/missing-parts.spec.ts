// Parts of the page that are fetched when they are first needed, and cannot be fetched: an error is
// shown in plain words, and Rhino's worker is fetched at the next attempt.

import { addConstraint, downloaded, openText, showStep, tool } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { expect, openPage, test, waitForState } from '../support.ts';

test.use({ fresh: true });

const N = 6;
const VERTICES = (N + 1) ** 2;

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

test('a plot that cannot be fetched is reported in plain words', async ({ page, complaints }) => {
  const part = '**/plot-*.js';
  await page.route(part, (route) => route.abort());
  await addConstraint(page, 'Plane', 'each face');
  await showStep(page, 'Check');
  const plot = page.getByRole('tabpanel', { name: 'Convergence' });
  await plot.scrollIntoViewIfNeeded();
  await page.keyboard.press('.');
  await expect(plot).toHaveText(
    'The plot could not be loaded: A part of the page could not be fetched. Check the network.',
  );
  expectOnlyAborted(complaints);
});

test('a Rhino file is written at the next press', async ({ page, complaints }) => {
  const part = '**/rhino-worker-*.js';
  await page.route(part, (route) => route.abort());
  await tool(page, 'More formats');
  const dialog = page.getByRole('dialog', { name: 'More formats' });
  const format = dialog.getByRole('button', { name: /^3DM/ });
  await format.click();
  await expect(dialog).toContainText('The .3dm converter could not be loaded. Check the network.');
  await page.unroute(part);
  const saved = await downloaded(page, () => format.click());
  expect(saved.name).toBe('grid.3dm');
  expectOnlyAborted(complaints);
});
