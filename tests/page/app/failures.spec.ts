// Failures of the solver and the graphics.

import type { Page } from '@playwright/test';
import { addConstraint, exported, openText, runToTheEnd, tool } from '../actions.ts';
import { quadScene, wavyGrid } from '../meshes.ts';
import { expect, openPage, state, test, waitForState } from '../support.ts';

/** Opens a grid, adds circle constraints on its faces and solves; returns the final state. */
async function openSolved(page: Page) {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  await addConstraint(page, 'Circle', 'each face');
  return runToTheEnd(page);
}

// Software rendering takes seconds per frame, in which the page cannot watch its solver.
test.describe('the solver', () => {
  test('a crashed solver is replaced, and the model is as before', async ({ page }) => {
    const before = await openSolved(page);
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
    expect(after.circularity?.max_distance).toBeCloseTo(
      before.circularity?.max_distance ?? NaN,
      12,
    );
    await runToTheEnd(page);
    // The new solver declares its kinds again, which makes no second command of each.
    await page.keyboard.press('Control+k');
    const palette = page.getByRole('dialog', { name: 'Commands' });
    await palette.getByRole('combobox').fill('panels flat');
    await expect(palette.getByRole('option')).toHaveText([/Make panels flat/]);
  });

  test('a solver that stops answering is replaced within five seconds, and undo still works', async ({
    page,
  }) => {
    const before = await openSolved(page);
    const [worker] = page.workers();
    await worker.evaluate(() => {
      setTimeout(() => {
        for (;;);
      });
    });
    await expect(page.getByRole('alert')).toContainText('did not answer', { timeout: 5000 });
    await expect(page.getByRole('alert')).toContainText(`iteration ${before.iteration}`);
    await page.getByRole('button', { name: 'Undo' }).click();
    await waitForState(page, (now) => now.iteration === 0);
    await page.getByRole('button', { name: 'Undo' }).click();
    await waitForState(page, (now) => Object.keys(now.constraints).length === 0);
  });

  test('long work is not mistaken for a hung solver, and can be stopped', async ({ page }) => {
    await openPage(page);
    await openText(page, 'grid.obj', wavyGrid(4), 25);
    const [worker] = page.workers();
    // Delays the next answer of the worker.
    await worker.evaluate(() => {
      const { postMessage } = self;
      self.postMessage = (message, ...rest) => {
        Reflect.apply(postMessage, self, [message, ...rest]);
        if (message.type !== 'working') return;
        for (const until = performance.now() + 7000; performance.now() < until;);
      };
    });
    await page.getByRole('button', { name: 'Step', exact: true }).click();
    const card = page.getByRole('group', { name: 'Long work' });
    await expect(card).toBeVisible();
    await card.getByRole('button', { name: 'Cancel' }).click();
    await expect(card).toBeHidden();
    await addConstraint(page, 'Circle', 'each face');
    await runToTheEnd(page);
  });

  test('a run of more than 300,000 iterations goes on', async ({ page }) => {
    await openPage(page);
    const scene = JSON.parse(quadScene(1));
    scene.constraints = [{ kind: 'circle', on: 'faces' }];
    scene.solver = { tolerance: 0 };
    await openText(page, 'endless.shapeup.json', JSON.stringify(scene), 4);
    await page.getByRole('button', { name: 'Run' }).click();
    // Passing that many values at once would exceed the limit of an argument list.
    await waitForState(page, (now) => now.iteration > 300_000);
    expect((await state(page)).running).toBe(true);
    await page.getByRole('button', { name: 'Pause' }).click();
    await expect(page.getByRole('alert')).toBeEmpty();
    await page.getByRole('tab', { name: 'Convergence' }).scrollIntoViewIfNeeded();
    await expect(page.getByText(/^Iteration/).first()).toBeVisible();
  });

  test('unexpected errors are shown', async ({ page, complaints }) => {
    await openPage(page);
    const alert = page.getByRole('alert');
    await page.evaluate(() => {
      setTimeout(() => {
        throw new Error('out of order');
      });
    });
    await expect(alert).toContainText('Something went wrong on this page: out of order');
    await expect(alert.getByRole('button', { name: 'Copy report' })).toBeVisible();
    await page.evaluate(() => void Promise.reject(new Error('nobody waited')));
    await expect(alert).toContainText('nobody waited');
    expect(complaints.splice(0)).toHaveLength(2);
  });
});

test('an export that fails is said in its dialog, which stays', async ({ page }) => {
  // One of the formats closed it, and said so in a message below.
  await openPage(page);
  await page.evaluate(() => {
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (message, ...rest) {
      const wrong = { ...message, name: 'nothing of this name' };
      const isOne = ['obj', 'meshFile'].includes(message.name);
      Reflect.apply(postMessage, this, [isOne ? wrong : message, ...rest]);
    };
  });
  await tool(page, 'More formats');
  const dialog = page.getByRole('dialog', { name: 'More formats' });
  for (const format of ['OBJ', 'PLY']) {
    await dialog.getByRole('button', { name: format }).first().click();
    await expect(dialog.getByText(/is not a function$/)).toBeVisible();
  }
  await expect(page.getByRole('alert')).toBeEmpty();
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+e');
  await expect(page.getByRole('alert')).toContainText('is not a function');
});

test('without graphics everything but the 3D view works', async ({ page }) => {
  await page.addInitScript(() => {
    const prototype: { getContext(kind: string, options?: unknown): unknown } =
      HTMLCanvasElement.prototype;
    const { getContext } = prototype;
    prototype.getContext = function (kind, ...rest) {
      return kind === '2d' ? getContext.call(this, kind, ...rest) : null;
    };
    Object.defineProperty(Navigator.prototype, 'gpu', { value: undefined });
  });
  await openPage(page);
  await expect(page.getByText('No 3D view')).toBeVisible();
  await expect(page.locator('#first-picture')).toHaveCount(0);
  expect((await state(page)).renderer).toBe('none');
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  await page.keyboard.press('Control+a');
  await page.keyboard.press('h');
  await waitForState(page, (now) => now.handles.length === 25);
  // The hint and the list of handles said to drag them.
  await expect(page.locator('#hint')).not.toHaveText(/[Dd]rag/);
  await expect(page.getByText('25 handles.', { exact: true })).toBeAttached();
  await page.keyboard.press('Control+z');
  await addConstraint(page, 'Circle', 'each face');
  const before = await state(page);
  const after = await runToTheEnd(page);
  expect(after.circularity?.max_distance).toBeLessThan(before.circularity?.max_distance ?? NaN);
  expect((await exported(page, 'OBJ')).text).toContain('\nf ');
});

test('a view that is restored knows what covers it', async ({ page }) => {
  await openPage(page, 'renderer=webgl2');
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  await page.getByRole('button', { name: 'Make panels flat' }).first().waitFor();
  /** Where a vertex is when the model is framed beside what covers the view. */
  const framed = async () => {
    await page.keyboard.press('Home');
    return page.evaluate(() => window.shapeUp.screen(0));
  };
  const before = await framed();
  await page.evaluate(() => {
    const canvas = document.querySelector('[role="application"] canvas') as HTMLCanvasElement;
    canvas.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
    canvas.dataset.lost = 'yes';
  });
  await expect(page.locator('[role="application"] canvas[data-lost]')).toHaveCount(0);
  await waitForState(page, (now) => now.renderer === 'webgl2');
  await expect(page.getByRole('status')).toHaveText('The 3D view was lost and is being restored');
  // The view knew of nothing that covers it.
  expect(await framed()).toEqual(before);
});
