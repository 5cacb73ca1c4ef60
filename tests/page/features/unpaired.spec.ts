// Constraints that act on pairs of vertices.

import { expect, openPage, test } from '../support.ts';

test.use({ sameDocument: true });

test('a symmetry reports how many vertices have a partner', async ({ page }) => {
  await openPage(page);
  const open = (mirror: number[]) =>
    page.evaluate((mirror) => {
      const positions = [
        [0, 0, 0],
        [1, 0, 0],
        [1, 1, 0],
        [0, 1, 0],
        [0.3, 2, 0],
      ];
      const scene = {
        ...{ format: 'shape-up-scene', version: 1, mesh: { positions, faces: [[0, 1, 2, 3]] } },
        constraints: [{ kind: 'symmetry', on: { vertices: '0-4' }, mirror }],
      };
      return window.shapeUp.open(scene, 'roof.shapeup.json');
    }, mirror);
  const notice = page.getByRole('group', { name: 'Vertices without a partner' });
  await open([1, 0.3, 0]);
  await expect(notice).toContainText('none of the 5 vertices has a partner');
  await open([1, 0, 0]);
  await expect(notice).toContainText('4 of 5 vertices have a partner; the others are free.');
  await notice.getByRole('button', { name: 'Close' }).click();
  await expect(notice).toBeHidden();
  // Opening another model shows the same message again.
  await open([1, 0, 0]);
  await expect(notice).toContainText('4 of 5 vertices have a partner; the others are free.');
});
