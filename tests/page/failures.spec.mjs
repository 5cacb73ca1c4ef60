// When something breaks: the solver, the graphics.

import { addConstraint, openText, runToTheEnd, exported } from './actions.mjs';
import { wavyGrid } from './meshes.mjs';
import { coloursOfView, expect, openPage, state, test, waitForState } from './support.mjs';

test('a solver that dies is replaced, with the model as it was', async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  await addConstraint(page, 'Circle', 'each face');
  const before = await runToTheEnd(page);
  const [worker] = page.workers();
  await worker.evaluate(() => {
    setTimeout(() => {
      throw new Error('out of order');
    });
  });
  await expect(page.getByRole('alert')).toContainText('was restarted');
  const after = await state(page);
  expect(after.constraints).toEqual(before.constraints);
  expect(after.iteration).toBe(before.iteration);
  await expect(page.getByRole('alert')).toContainText(`iteration ${before.iteration}`);
  await expect(page.getByText('grid.obj', { exact: true })).toBeVisible();
  expect(after.circularity.max_distance).toBeCloseTo(before.circularity.max_distance, 12);
  await runToTheEnd(page);
});

test('without graphics everything but the picture works', async ({ page }) => {
  await page.addInitScript(() => {
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
      return kind === '2d' ? getContext.call(this, kind, ...rest) : null;
    };
    Object.defineProperty(Navigator.prototype, 'gpu', { value: undefined });
  });
  await openPage(page);
  await expect(page.getByText('No 3D picture')).toBeVisible();
  expect((await state(page)).renderer).toBe('none');
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  await addConstraint(page, 'Circle', 'each face');
  const before = await state(page);
  const after = await runToTheEnd(page);
  expect(after.circularity.max_distance).toBeLessThan(before.circularity.max_distance);
  expect((await exported(page, 'OBJ')).text).toContain('\nf ');
});

test('a lost graphics context comes back', async ({ page }) => {
  await openPage(page, 'backend=webgl2');
  await expect.poll(() => coloursOfView(page)).toBeGreaterThan(50);
  await page.evaluate(() => {
    const canvas = document.querySelector('[role="application"] canvas');
    canvas.getContext('webgl2').getExtension('WEBGL_lose_context').loseContext();
    canvas.dataset.lost = 'yes';
  });
  await expect(page.locator('[role="application"] canvas[data-lost]')).toHaveCount(0);
  await waitForState(page, (now) => now.renderer === 'webgl2');
  await expect(page.getByRole('status')).toHaveText('The 3D picture was lost and is drawn anew');
  await expect.poll(() => coloursOfView(page)).toBeGreaterThan(50);
});
