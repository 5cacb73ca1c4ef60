// What the faces are coloured by.

import { addConstraint, openExample, openText, showPanel, tool } from './actions.mjs';
import { wavyGrid } from './meshes.mjs';
import { expect, openPage, test, waitForState } from './support.mjs';

test('faces are coloured by what is asked of them, until somebody chooses', async ({ page }) => {
  await openPage(page);
  await showPanel(page, 'Energies and display');
  const colours = page.getByLabel('Colour by');
  const legend = page.getByText('Refit colours');
  await expect(colours).toHaveValue('circularity');
  await expect(legend).toBeVisible();
  await openExample(page, 'Hypar');
  await expect(colours).toHaveValue('planarity');

  // Nothing is asked of a mesh from a file.
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  await expect(colours).toHaveValue('');
  await expect(legend).toBeHidden();
  await addConstraint(page, 'Circle', 'each face');
  await expect(legend).toBeVisible();
  await showPanel(page, 'Energies and display');
  await expect(colours).toHaveValue('circularity');

  await colours.selectOption('planarity');
  await tool(page, 'Undo');
  await waitForState(page, (now) => now.constraints.circle === undefined);
  await addConstraint(page, 'Circle', 'each face');
  await showPanel(page, 'Energies and display');
  await expect(colours).toHaveValue('planarity');
});

test('flat faces are not coloured by rounding', async ({ page }) => {
  await openPage(page);
  // Exactly flat, but for the last digits of these decimals.
  const corners = [0, 0.1, 0.2, 0.3].flatMap((x) => [0, 0.7].map((y) => [x, y, x / 3 + y / 7]));
  const rows = corners.map((corner) => `v ${corner.join(' ')}`);
  await openText(page, 'flat.obj', `${rows.join('\n')}\nf 1 2 4 3\nf 3 4 6 5\nf 5 6 8 7\n`, 8);
  await addConstraint(page, 'Plane', 'each face');
  await expect(page.getByText('worst 0', { exact: true })).toBeVisible();
  await showPanel(page, 'Energies and display');
  await expect(page.getByTitle('Shape energy, without its weight')).toHaveText('0');
});
