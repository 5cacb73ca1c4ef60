// What takes long runs in a second worker: the first one answers meanwhile, and it can be cancelled.

import { openText, showStep } from '../actions.ts';
import { holdingAnswers } from '../answers.ts';
import { wavyGrid } from '../meshes.ts';
import { expect, openPage, screenOf, test, waitForState } from '../support.ts';

/** Panels along a side. */
const SIDE = 4;
const VERTICES = (SIDE + 1) ** 2;

test('while parts are made, edits are answered; making them can be cancelled and begun again', async ({
  page,
}) => {
  const answers = await holdingAnswers(page);
  await openPage(page);
  await openText(page, 'roof.obj', `# units: m\n${wavyGrid(SIDE)}`, VERTICES);
  const [x, y] = await screenOf(page, (VERTICES - 1) / 2);
  await page.mouse.dblclick(x, y);
  await waitForState(page, (now) => now.handles.length === 1);
  await showStep(page, 'Shape');
  // As of a large mesh, whose parts take seconds.
  await answers.hold('build');
  await page.getByRole('button', { name: 'Build', exact: true }).click();
  await answers.come('jobs: build');
  const work = page.getByRole('group', { name: 'Long work' });
  await expect(work).toBeVisible();
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await waitForState(page, (now) => now.handles.length === 0 && now.build === null);
  await expect(work).toBeVisible();

  await work.getByRole('button', { name: 'Cancel' }).click();
  await expect(work).toBeHidden();
  const panel = page.getByRole('region', { name: 'Build: parts and sheets' });
  await expect(panel.getByText('Cancelled.')).toBeVisible();
  await expect(panel.getByRole('button', { name: 'Build again' })).toBeEnabled();
  await expect(page.getByRole('alert')).toBeEmpty();
  // What a worker that was ended has answered does not come.
  await answers.hold();
  await panel.getByRole('button', { name: 'Close build: parts and sheets' }).click();
  await page.getByRole('button', { name: 'Build', exact: true }).click();
  await waitForState(page, (now, panels) => now.build?.panels === panels, SIDE * SIDE);
  await expect(panel.getByText('Cancelled.')).toBeHidden();
});
