// Work is saved in this browser, separately for each tab.

import type { BrowserContext, Page } from '@playwright/test';
import { addConstraint, downloaded, openExample, openText, runToTheEnd, tool } from '../actions.ts';
import { endlessScene, wavyGrid } from '../meshes.ts';
import {
  boxOf,
  expect,
  hold,
  known,
  positionOf,
  sceneOf,
  screenOf,
  settled,
  state,
  test,
  visit,
  waitForState,
} from '../support.ts';

test.use({ fresh: true });

/** Waits until everything is saved. */
const kept = (page: Page) =>
  expect
    .poll(() => page.evaluate(() => document.querySelector('#numbers')?.textContent))
    .toContain('Saved in this browser');

const back = (page: Page) => page.getByRole('alert').getByText(/ is back\./);

test('work is restored after the tab was killed', async ({ page, context }) => {
  await visit(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await addConstraint(page, 'Plane', 'each face');
  const before = await runToTheEnd(page);
  const corner = await positionOf(page, 24);
  await kept(page);

  // A page gets no event when its process is killed.
  const session = await context.newCDPSession(page);
  session.send('Page.crash').catch(() => {});
  await page.waitForEvent('crash');
  await page.close();
  const again = await context.newPage();
  await visit(again);
  // The iteration count comes with the first frame.
  const after = await waitForState(again, (now, at) => now.iteration === at, before.iteration);
  expect(after.constraints).toEqual({ plane: 16 });
  expect(await positionOf(again, 24)).toEqual(corner);
  await expect(back(again)).toContainText('roof.obj');
  // Shown under its own name, not the name under which the scene was saved.
  const panel = again.getByRole('complementary', { name: 'Steps' });
  await expect(panel.getByText('roof.obj', { exact: true })).toBeVisible();

  await again.getByRole('button', { name: 'Start fresh' }).click();
  await waitForState(again, (now) => now.vertices > 25);
  await visit(again);
  expect((await state(again)).vertices).toBeGreaterThan(25);
  // The work is still listed.
  await tool(again, 'Open recent');
  await again.getByRole('menuitem', { name: 'roof.obj' }).click();
  await waitForState(again, (now) => now.vertices === 25 && now.iteration > 0);
});

test('an unchanged example that was chosen from the menu is opened again by a reload', async ({
  page,
}) => {
  // The address did not name it, and it is not saved: the first example came instead.
  await visit(page);
  await openExample(page, 'Hypar');
  await expect(page).toHaveURL(/#example=hypar$/);
  const { vertices } = await state(page);
  await page.reload();
  await waitForState(page, (now, count) => now.vertices === count, vertices);
  await expect(page.getByRole('status')).toHaveText(/Opened the example Hypar/);
});

test('work stays the last one where the solver could not be fetched', async ({
  page,
  context,
  complaints,
}) => {
  // It was taken for unreadable, and the next tab did not bring it back.
  await visit(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await kept(page);
  await page.route('**/assets/engine-*.wasm', (route) => route.abort());
  await page.reload();
  await expect(page.getByRole('alert')).toContainText('The solver could not be started');
  complaints.length = 0;
  await page.close();
  const again = await context.newPage();
  await visit(again);
  await expect(back(again)).toContainText('roof.obj');
});

test('two tabs do not overwrite each other', async ({ page, context }) => {
  await visit(page);
  await openText(page, 'one.obj', wavyGrid(2), 9);
  await kept(page);
  const second = await context.newPage();
  await visit(second);
  // The second tab does not take over the work of a tab that is still open.
  expect((await state(second)).vertices).toBeGreaterThan(9);
  await openText(second, 'two.obj', wavyGrid(3), 16);
  await kept(second);
  for (const [tab, vertices] of [
    [page, 9],
    [second, 16],
  ] as const) {
    await visit(tab);
    await expect(back(tab)).toBeVisible();
    expect((await state(tab)).vertices).toBe(vertices);
  }
});

test('autosave is on before the first example is there', async ({ page }) => {
  // It used to start after the first example: on a busy machine an edit followed quickly by a
  // reload was lost.
  const release = await hold(page, '**/examples/index.json');
  await page.goto('./');
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await kept(page);
  const list = page.waitForResponse('**/examples/index.json');
  release();
  await list;
  expect((await state(page)).vertices).toBe(25);
});

/** Changes a weight, and reloads or leaves as soon as the solver has answered. */
const editAndThen = (tab: Page, weight: number, then: '' | 'reload' | 'leave' | 'close') =>
  tab.evaluate(
    async ([weight, then]) => {
      const field = document.querySelector('[aria-label="Shape weight"]') as HTMLInputElement;
      field.value = String(weight);
      field.dispatchEvent(new Event('change', { bubbles: true }));
      while (window.shapeUp.scene().weights?.shape !== weight) {
        await new Promise((done) => setTimeout(done));
      }
      if (then === 'reload') location.reload();
      if (then === 'leave') location.href = 'about:blank';
    },
    [weight, then] as const,
  );

for (const way of ['reload', 'leave', 'close'] as const) {
  test(`an edit is kept when followed at once by: ${way}`, async ({ page, context }) => {
    let tab = page;
    await visit(tab);
    await openText(tab, 'roof.obj', wavyGrid(20), 441);
    for (const weight of [3, 7]) {
      // Two edits in a row: the second is made while the first is still being written.
      await editAndThen(tab, weight - 1, '');
      const loaded = way === 'reload' ? tab.waitForEvent('load') : null;
      await editAndThen(tab, weight, way).catch(() => {});
      await loaded;
      if (way === 'close') {
        await tab.close();
        tab = await context.newPage();
      }
      if (way === 'leave') await tab.waitForURL('about:blank');
      if (way !== 'reload') await visit(tab);
      await expect(back(tab)).toContainText('roof.obj');
      await waitForState(tab, (now) => now.vertices === 441);
      expect((await sceneOf(tab)).weights.shape).toBe(weight);
    }
  });
}

test('two tabs reloaded at the same moment each keep their edit', async ({ page, context }) => {
  const second = await context.newPage();
  const tabs = [
    { tab: page, name: 'one.obj', cells: 20, vertices: 441, weight: 3 },
    { tab: second, name: 'two.obj', cells: 30, vertices: 961, weight: 7 },
  ];
  for (const { tab, name, cells, vertices } of tabs) {
    await visit(tab);
    await openText(tab, name, wavyGrid(cells), vertices);
  }
  await Promise.all(
    tabs.map(async ({ tab, weight }) => {
      const loaded = tab.waitForEvent('load');
      await editAndThen(tab, weight, 'reload').catch(() => {});
      await loaded;
    }),
  );
  for (const { tab, name, vertices, weight } of tabs) {
    await expect(back(tab)).toContainText(name);
    await waitForState(tab, (now, count) => now.vertices === count, vertices);
    expect((await sceneOf(tab)).weights.shape).toBe(weight);
  }
});

test('an edit made before the page has settled after a reload is kept', async ({ page }) => {
  // Such an edit used to be mistaken for the state saved before.
  await visit(page);
  await openText(page, 'roof.obj', wavyGrid(20), 441);
  await editAndThen(page, 3, '');
  await expect(page.getByText(/^Saved in this browser/)).toBeVisible();
  await page.evaluate(() => sessionStorage.setItem('test.edit', '11'));
  await page.addInitScript(() => {
    const weight = sessionStorage.getItem('test.edit');
    sessionStorage.removeItem('test.edit');
    const edit = () => {
      const field = document.querySelector<HTMLInputElement>('[aria-label="Shape weight"]');
      if (!window.shapeUp?.scene() || !field) return void setTimeout(edit);
      field.value = weight ?? '';
      field.dispatchEvent(new Event('change', { bubbles: true }));
    };
    if (weight) edit();
  });
  for (let time = 0; time < 2; time++) {
    await page.reload();
    // On a busy machine it is asked before the page has begun.
    const scene = () => sceneOf(page).catch(() => null);
    await expect.poll(async () => (await scene())?.weights.shape).toBe(11);
  }
});

test('an edit is kept even if the browser drops the last transaction of a closing page', async ({
  page,
}) => {
  await visit(page);
  await openText(page, 'roof.obj', wavyGrid(20), 441);
  await editAndThen(page, 3, '');
  await expect(page.getByText(/^Saved in this browser/)).toBeVisible();
  // On a busy machine 3 of 80 pages were closed before their last transaction had begun.
  await page.evaluate(() => {
    IDBTransaction.prototype.commit = function () {
      this.abort();
    };
  });
  await editAndThen(page, 7, 'leave').catch(() => {});
  await page.waitForURL('about:blank');
  await visit(page);
  await expect(back(page)).toContainText('roof.obj');
  expect((await sceneOf(page)).weights.shape).toBe(7);
  await tool(page, 'Undo');
  await expect.poll(async () => (await sceneOf(page)).weights.shape).toBe(3);
  // By now the copy in localStorage has moved to the database.
  const aside = () =>
    Object.keys(localStorage).filter((key) => key.startsWith('shape-up.last-moment'));
  expect(await page.evaluate(aside)).toEqual([]);
});

test('an interrupted run is restored as one undo step', async ({ page, context }) => {
  await visit(page);
  await openText(page, 'endless.shapeup.json', endlessScene(), 41 * 41);
  await page.getByRole('button', { name: 'Run' }).click();
  const progress = () =>
    page.evaluate(
      () =>
        new Promise<number>((done) => {
          const open = indexedDB.open('shape-up');
          open.onsuccess = () => {
            const { result } = open;
            const keys = result.transaction('works').objectStore('works').getAllKeys();
            keys.onsuccess = () => {
              result.close();
              done(keys.result.filter((key) => String(key).startsWith('progress ')).length);
            };
          };
        }),
    );
  await expect.poll(progress).toBe(1);
  const session = await context.newCDPSession(page);
  session.send('Page.crash').catch(() => {});
  await page.waitForEvent('crash');
  await page.close();
  const again = await context.newPage();
  await visit(again);
  const { iteration } = await waitForState(again, (now) => now.iteration > 0);
  await again.getByRole('button', { name: 'Undo' }).click();
  await expect(again.getByRole('status')).toContainText(`Run, ${iteration} iteration`);
  await waitForState(again, (now) => now.iteration === 0);
});

test('the undo history, camera, tolerance and plot are restored after a reload', async ({
  page,
}) => {
  await visit(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await addConstraint(page, 'Plane', 'each face');
  await runToTheEnd(page);
  await tool(page, 'Undo');
  await waitForState(page, (now) => now.iteration === 0);
  const view = page.getByRole('application', { name: '3D view' });
  const { x, y, width, height } = await boxOf(view);
  await page.mouse.move(x + width / 2, y + height - 30);
  await page.mouse.down({ button: 'right' });
  await page.mouse.move(x + width / 2 + 120, y + height - 70, { steps: 3 });
  await page.mouse.up({ button: 'right' });
  const tolerance = page.getByRole('spinbutton', { name: 'Tolerance' });
  await tolerance.fill('0.3');
  await tolerance.press('Enter');
  await page.getByRole('tab', { name: 'Worst' }).click();
  const corner = known(await page.evaluate(() => window.shapeUp.screen(0)));
  const shown = await tolerance.inputValue();

  await page.reload();
  await expect(back(page)).toContainText('roof.obj');
  await expect(page.getByRole('tab', { name: 'Worst' })).toHaveAttribute('aria-selected', 'true');
  await expect(tolerance).toHaveValue(shown);
  const now = await screenOf(page, 0);
  for (const axis of [0, 1]) expect(now[axis]).toBeCloseTo(corner[axis], 0);
  await tool(page, 'Redo');
  await waitForState(page, (state) => state.iteration > 0);
  await tool(page, 'Undo');
  await tool(page, 'Undo');
  await waitForState(page, (state) => Object.keys(state.constraints).length === 0);
});

/** Changes saved records, as a damaged disk would. */
const damage = (page: Page, part: string, value: unknown) =>
  page.evaluate(
    ([part, value]) =>
      new Promise<void>((done) => {
        const open = indexedDB.open('shape-up');
        open.onsuccess = () => {
          const transaction = open.result.transaction('works', 'readwrite');
          const store = transaction.objectStore('works');
          const keys = store.getAllKeys();
          keys.onsuccess = () => {
            for (const key of keys.result) if (String(key).startsWith(part)) store.put(value, key);
          };
          transaction.oncomplete = () => {
            open.result.close();
            done();
          };
        };
      }),
    [part, value] as const,
  );

/**
 * Changes the named parts of the saved records. The page is left before, because it saves on
 * leaving.
 */
async function damageSaved(page: Page, context: BrowserContext, parts: Record<string, unknown>) {
  const url = page.url();
  await page.goto('about:blank');
  const other = await context.newPage();
  await other.goto(new URL('gallery.html', url).href);
  for (const [part, value] of Object.entries(parts)) await damage(other, `${part} `, value);
  await other.close();
}

test('saved work that cannot be read is reported and can be downloaded, and saving goes on', async ({
  page,
  context,
}) => {
  await visit(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await kept(page);
  await damageSaved(page, context, {
    text: '{ "format": "shape-up-scene", "version": 1, "mesh": ',
  });

  await visit(page);
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('roof.obj is saved in this browser, but cannot be opened');
  const file = await downloaded(page, () =>
    alert.getByRole('button', { name: 'Save its file' }).click(),
  );
  expect(file.name).toBe('roof.shapeup.json');
  expect(file.text).toContain('"mesh": ');
  // Its entry under Open recent reports the same, since no other tab has it open.
  await tool(page, 'Open recent');
  await page.getByRole('menuitem', { name: 'roof.obj' }).click();
  await expect(alert).toContainText('cannot be opened');
  // Other work is not affected.
  await openText(page, 'next.obj', wavyGrid(3), 16);
  await kept(page);
  await visit(page);
  await expect(back(page)).toContainText('next.obj');
});

test('damage to the records beside a saved work loses only what they contain', async ({
  page,
  context,
}) => {
  await visit(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await addConstraint(page, 'Plane', 'each face');
  await kept(page);
  await damageSaved(page, context, { work: 'no work', history: new Uint8Array([1, 2, 3]) });
  const again = await context.newPage();
  await visit(again);
  await expect(again.getByRole('alert')).toContainText('undo history is lost');
  expect((await state(again)).constraints).toEqual({ plane: 16 });
  await openText(again, 'next.obj', wavyGrid(3), 16);
  await kept(again);
  await tool(again, 'Open recent');
  await expect(again.getByRole('menuitem', { name: 'Recovered model' })).toBeVisible();
});

test('an unedited example is not saved', async ({ page }) => {
  await visit(page);
  // By now the tab has a name for its work, and all its saving has finished.
  await page.waitForFunction(() => sessionStorage.getItem('shape-up.work'));
  await settled(page);
  await visit(page);
  await expect(back(page)).toBeHidden();
  await tool(page, 'Open recent');
  const menu = page.getByRole('menu', { name: 'Open recent' });
  await expect(menu).toContainText('Nothing else yet');
  // Its button closes it: it used to open it again.
  const button = page.getByRole('button', { name: 'Open recent', exact: true });
  await button.click();
  await expect(menu).toBeHidden();
  await button.click();
  await expect(menu).toBeVisible();
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
] as const) {
  test(`with storage ${what} the page works and shows a quiet note`, async ({ page }) => {
    await page.addInitScript(block);
    await visit(page);
    await openText(page, 'roof.obj', wavyGrid(4), 25);
    await expect
      .poll(() => page.evaluate(() => document.querySelector('#numbers')?.textContent))
      .toContain('Autosave is off: use Save scene');
    // Shown in every window, unlike the note that the work is saved.
    await page.setViewportSize({ width: 390, height: 844 });
    await expect(page.getByText('Autosave is off: use Save scene')).toBeInViewport();
    await expect(page.getByRole('alert')).toBeEmpty();
    await visit(page);
    expect((await state(page)).vertices).toBeGreaterThan(25);
  });
}
