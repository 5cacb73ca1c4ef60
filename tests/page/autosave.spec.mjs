// What is done stays in this browser, each tab's own.

import { addConstraint, openText, runToTheEnd, tool } from './actions.mjs';
import { quadScene, wavyGrid } from './meshes.mjs';
import { expect, positionOf, state, test, visit, waitForState } from './support.mjs';

test.use({ pixels: false });

/** A scene that needs many more iterations than there is time for. */
function endlessScene() {
  const scene = JSON.parse(quadScene(40));
  scene.constraints = [{ kind: 'circle', on: 'faces' }];
  scene.solver = { tolerance: 0, accelerator: 'none' };
  return JSON.stringify(scene);
}

/** Everything is saved. */
const kept = (page) =>
  expect
    .poll(() => page.evaluate(() => document.querySelector('#numbers')?.textContent))
    .toContain('Saved in this browser');

const back = (page) => page.getByRole('alert').getByText('is back as you left it');

test('work is back after the tab was killed', async ({ page, context }) => {
  await visit(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await addConstraint(page, 'Plane', 'each face');
  const before = await runToTheEnd(page);
  const corner = await positionOf(page, 24);
  await kept(page);

  // No event tells a page that its process is killed.
  const session = await context.newCDPSession(page);
  session.send('Page.crash').catch(() => {});
  await page.waitForEvent('crash');
  await page.close();
  const again = await context.newPage();
  await visit(again);
  // The numbers come with the first frame.
  const after = await waitForState(again, (now, at) => now.iteration === at, before.iteration);
  expect(after.constraints).toEqual({ plane: 16 });
  expect(await positionOf(again, 24)).toEqual(corner);
  await expect(back(again)).toContainText('roof.obj');
  // Under its own name, not under that of the scene that it was kept as.
  const panel = again.getByRole('complementary', { name: 'Model' });
  await expect(panel.getByText('roof.obj', { exact: true })).toBeVisible();

  await again.getByRole('button', { name: 'Start fresh' }).click();
  await waitForState(again, (now) => now.vertices > 25);
  await visit(again);
  expect((await state(again)).vertices).toBeGreaterThan(25);
  // It is not lost.
  await tool(again, 'Open recent');
  await again.getByRole('menuitem', { name: 'roof.obj' }).click();
  await waitForState(again, (now) => now.vertices === 25 && now.iteration > 0);
});

test('two tabs do not overwrite each other', async ({ page, context }) => {
  await visit(page);
  await openText(page, 'one.obj', wavyGrid(2), 9);
  await kept(page);
  const second = await context.newPage();
  await visit(second);
  // The work of a tab that is open is not taken from it.
  expect((await state(second)).vertices).toBeGreaterThan(9);
  await openText(second, 'two.obj', wavyGrid(3), 16);
  await kept(second);
  for (const [tab, vertices] of [
    [page, 9],
    [second, 16],
  ]) {
    await visit(tab);
    await expect(back(tab)).toBeVisible();
    expect((await state(tab)).vertices).toBe(vertices);
  }
});

test('a run saves nothing until it rests', async ({ page }) => {
  await page.addInitScript(() => {
    window.puts = 0;
    const { put } = IDBObjectStore.prototype;
    IDBObjectStore.prototype.put = function (...values) {
      window.puts += 1;
      return put.apply(this, values);
    };
  });
  await visit(page);
  await openText(page, 'endless.shapeup.json', endlessScene(), 41 * 41);
  await kept(page);
  const before = await page.evaluate(() => window.puts);
  expect(before).toBeGreaterThan(0);
  await page.getByRole('button', { name: 'Run' }).click();
  // Longer than it would wait, and than the worker does between the scenes of a run.
  await page.waitForTimeout(5000);
  expect((await state(page)).running).toBe(true);
  expect(await page.evaluate(() => window.puts)).toBe(before);
  await page.getByRole('button', { name: 'Pause' }).click();
  await expect.poll(() => page.evaluate(() => window.puts)).toBeGreaterThan(before);
});

test('an example that nobody touched is not kept', async ({ page }) => {
  await visit(page);
  await page.waitForTimeout(2500);
  await visit(page);
  await expect(back(page)).toBeHidden();
  await tool(page, 'Open recent');
  await expect(page.getByRole('menu', { name: 'Open recent' })).toContainText('Nothing else yet');
});

for (const [what, block] of [
  [
    'blocked',
    () => {
      IDBFactory.prototype.open = () => {
        throw new DOMException('The operation is insecure.', 'SecurityError');
      };
    },
  ],
  [
    'full',
    () => {
      IDBObjectStore.prototype.put = () => {
        throw new DOMException('There is no room.', 'QuotaExceededError');
      };
    },
  ],
]) {
  test(`where storage is ${what} the page works, and says so quietly`, async ({ page }) => {
    await page.addInitScript(block);
    await visit(page);
    await openText(page, 'roof.obj', wavyGrid(4), 25);
    await expect
      .poll(() => page.evaluate(() => document.querySelector('#numbers')?.textContent))
      .toContain('Autosave is off: use Save scene');
    // In every window, unlike that it is saved.
    await page.setViewportSize({ width: 390, height: 844 });
    await expect(page.getByText('Autosave is off: use Save scene')).toBeInViewport();
    await expect(page.getByRole('alert')).toBeEmpty();
    await visit(page);
    expect((await state(page)).vertices).toBeGreaterThan(25);
  });
}
