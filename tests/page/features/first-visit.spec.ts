// The first visit of a user.

import { openExample, runToTheEnd } from '../actions.ts';
import {
  coloursOfView,
  dragVertex,
  everything,
  expect,
  looks,
  openPage,
  screenOf,
  state,
  test,
  visit,
  waitForState,
  type PageState,
} from '../support.ts';

declare global {
  interface Window {
    /** The number of pictures that the page has asked for. */
    pictures: number;
    /** The time at which the picture of the example was painted. */
    pictureAt?: number;
  }
}

test.use({ fresh: true });

/** The largest distance of a panel's corners from a circle. */
const offCircle = ({ circularity }: PageState) => circularity?.max_distance ?? NaN;

test('text and tools appear before the solver and the view', async ({ page }) => {
  // Neither module ever arrives.
  await page.route('**/{engine,view}-*.wasm', () => {});
  await page.goto('./');
  await expect(page.getByRole('heading', { level: 1, name: 'Shape-Up' })).toBeVisible();
  await expect(page.getByRole('button', { name: 'Run' })).toBeVisible();
  await expect(page.getByRole('application', { name: '3D view' })).toBeVisible();
  await expect(page.getByLabel('Open file')).toBeAttached();
});

test('the example appears solved, and then the page is idle', looks, async ({ page }) => {
  await page.addInitScript(() => {
    const { requestAnimationFrame: ask } = window;
    window.pictures = 0;
    window.requestAnimationFrame = (draw) => {
      window.pictures += 1;
      return ask(draw);
    };
  });
  await visit(page);
  // The first state of the example is the solved one.
  const { iteration } = await waitForState(page, (now) => now.energy !== null);
  expect(iteration).toBeGreaterThan(100);
  const { running, circularity, exact } = await waitForState(page, (now) => now.converged);
  expect(running).toBe(false);
  expect(exact?.met).toBe(true);
  expect(circularity?.max_distance).toBeLessThan(1e-10);
  await expect(page.getByRole('status')).toHaveText(`Converged after ${iteration} iterations`);
  await expect(page.getByRole('button', { name: 'Undo' })).toHaveAttribute(
    'title',
    new RegExp(`^Undo: Run, ${iteration} iterations`),
  );
  await expect(page.locator('#legend').getByText('Worst 0 mm')).toBeVisible();

  await waitForState(page, (now) => now.renderer.startsWith('web'));
  await expect(page.locator('#first-picture')).toHaveCount(0);
  expect(await coloursOfView(page)).toBeGreaterThan(50);
  // The colour range is that of the whole run, whose start had many times the error.
  const legend = page.getByRole('img', { name: /^432 faces between 0 and 0 mm/ });
  await expect(legend).toHaveAccessibleName(/originally up to \d+ mm$/);
  expect(Number(await page.getByLabel('Colours to').inputValue())).toBeGreaterThan(0.1);

  const pictures = () => page.evaluate(() => window.pictures);
  expect(await pictures()).toBeGreaterThan(0);
  // All pending work has ended once the count stays the same.
  let last = -1;
  await expect
    .poll(async () => {
      const now = await pictures();
      const drawn = now - last;
      last = now;
      return drawn;
    })
    .toBe(0);
});

test('Undo and Reset lead to the start, Redo and Run to the same solved shape', async ({
  page,
}) => {
  await visit(page);
  const press = (name: string) => page.getByRole('button', { name, exact: true }).click();
  await waitForState(page, (now) => now.converged);
  const solved = await everything(page);
  const total = (await state(page)).energy?.total ?? NaN;
  await press('Undo');
  await expect(page.getByRole('status')).toHaveText(`Undid: Run, ${solved.iteration} iterations`);
  const { circularity, converged } = await waitForState(page, (now) => now.iteration === 0);
  expect(converged).toBe(false);
  expect(circularity?.max_distance).toBeGreaterThan(0.1);
  const start = await everything(page);

  await press('Redo');
  await waitForState(page, (now) => now.iteration > 0);
  expect(await everything(page)).toEqual(solved);
  await press('Reset');
  await waitForState(page, (now) => now.iteration === 0);
  expect(await everything(page)).toEqual(start);
  // The solver keeps state from earlier runs, so the result agrees only up to its tolerance.
  const { energy } = await runToTheEnd(page);
  expect((energy?.total ?? NaN) / total).toBeCloseTo(1, 4);

  // Its link and its entry in the examples menu open it at its start.
  await openExample(page, 'Canopy');
  expect(await everything(page)).toEqual(start);
  await openPage(page);
  await waitForState(page, (now) => now.energy !== null);
  expect(await everything(page)).toEqual(start);
});

test("the first minute: drag, Reset and Run, then a model of one's own, and no more hints", async ({
  page,
}) => {
  const began = Date.now();
  await visit(page);
  const before = await waitForState(page, (now) => now.converged);
  await expect(page.getByText('Make any mesh buildable:')).toBeVisible();
  const hint = page.locator('#hint-card .said');
  await expect(hint).toHaveText(
    /^The corners of each panel lie on a circle, exactly\. Drag a blue handle/,
  );
  expect(before.exact?.met).toBe(true);
  const solvedAfter = Date.now() - began;

  const [soft] = before.handles.filter((handle) => !handle.fixed);
  const [x, y] = await screenOf(page, soft.vertex);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 10, y - 30, { steps: 5 });
  // The mesh follows, and stays near its circles.
  const followed = (now: PageState, { iteration }: PageState) =>
    now.iteration > iteration && (now.circularity?.max_distance ?? NaN) < 0.01;
  await waitForState(page, followed, before);
  // What does not hold during a drag is not said to hold.
  await expect(hint).toHaveText(/^Wanted: the corners of each panel lie on a circle\. The legend /);
  await expect(page.locator('#legend')).toContainText(/Worst \d/);
  await page.mouse.up();
  // After the drag it is exact again.
  const held = await waitForState(page, (now) => !now.running && now.exact?.met === true);
  expect(offCircle(held)).toBeLessThan(1e-8);

  await expect(hint).toHaveText(
    'Press Reset to go back to the original. Undo brings your shape back.',
  );
  await page.getByRole('button', { name: 'Reset' }).click();
  await expect(hint).toHaveText('This is the original. Press Run.');
  const start = await state(page);
  expect(start.iteration).toBe(0);
  expect(offCircle(start)).toBeGreaterThan(10 * offCircle(held));
  const after = await runToTheEnd(page);
  expect(offCircle(after)).toBeLessThan(0.2 * offCircle(start));
  expect(after.exact?.met).toBe(true);
  await expect(hint).toHaveText('Your turn: open a mesh of your own, or try another example.');
  const seconds = (Date.now() - began) / 1000;
  const description = `solved after ${solvedAfter} ms, all of it ${seconds} s`;
  test.info().annotations.push({ type: 'first minute', description });
  expect(seconds, description).toBeLessThan(60);

  // The last hint was not dismissed and no work was opened; clearing the storage simulates a new
  // tab.
  await page.evaluate(() => (sessionStorage.clear(), localStorage.removeItem('shape-up.works')));
  await visit(page);
  await waitForState(page, (now) => now.handles.length > 0 && now.converged);
  await expect(hint).toBeHidden();
});

test('hints follow another order of actions too, and stay away once dismissed', async ({
  page,
}) => {
  await visit(page);
  const hint = page.locator('#hint-card .said');
  await page.getByRole('button', { name: 'Reset' }).click();
  await expect(hint).toContainText('Press Run');
  await runToTheEnd(page);
  await expect(hint).toContainText('Drag a blue handle');
  const [soft] = (await state(page)).handles.filter((handle) => !handle.fixed);
  await dragVertex(page, soft.vertex, [10, -20]);
  await expect(hint).toContainText('open a mesh of your own');
  // Nothing covers the model after success.
  await waitForState(page, (now) => now.converged);
  await page.getByRole('button', { name: 'Dismiss hint' }).click();
  await expect(hint).toBeHidden();
  await page.evaluate(() => (sessionStorage.clear(), localStorage.removeItem('shape-up.works')));
  await visit(page);
  await waitForState(page, (now) => now.converged);
  await expect(hint).toBeHidden();
});

test("the example is painted within a second after the page's bytes arrive", async ({ page }) => {
  await page.addInitScript(() => {
    // The first frame that shows the picture.
    const look = () => {
      if (!document.querySelector<HTMLImageElement>('#first-picture img')?.naturalWidth) {
        requestAnimationFrame(look);
        return;
      }
      requestAnimationFrame(() => requestAnimationFrame((time) => (window.pictureAt = time)));
    };
    look();
  });
  /** The time in ms from the last byte of the page to the first paint of the picture. */
  const wait = async (address: string, picture: boolean) => {
    await page.goto(address);
    await page.waitForFunction(
      (wanted) =>
        performance.getEntriesByName('first-contentful-paint').length > 0 &&
        ((window.pictureAt ?? 0) > 0 || !wanted),
      picture,
    );
    return page.evaluate(() => {
      const [{ responseEnd }] = performance.getEntriesByType(
        'navigation',
      ) as PerformanceNavigationTiming[];
      const [{ startTime }] = performance.getEntriesByName('first-contentful-paint');
      return Math.max(startTime, window.pictureAt ?? 0) - responseEnd;
    });
  };
  // To exclude other load on the machine: the best of a few visits, less the time that this browser
  // needs for a page of one word.
  await page.route('**/word.html', (route) =>
    route.fulfill({ contentType: 'text/html', body: '<!doctype html><p>Word' }),
  );
  const [words, pictures]: number[][] = [[], []];
  for (let visit = 0; visit < 4; visit++) {
    words.push(await wait('./word.html', false));
    pictures.push(await wait('./', true));
  }
  const description = `${pictures.map(Math.round)} ms, a word ${words.map(Math.round)} ms`;
  test.info().annotations.push({ type: 'first picture', description });
  expect(Math.min(...pictures) - Math.min(...words), description).toBeLessThan(1000);
});

test('the examples menu opens another model, and the chosen theme is remembered', async ({
  page,
}) => {
  await openPage(page);
  const before = await state(page);
  await openExample(page, 'Hypar');
  expect((await state(page)).vertices).not.toBe(before.vertices);
  expect(await page.getByRole('menuitem', { includeHidden: true }).count()).toBeGreaterThan(2);
  const theme = () => page.evaluate(() => document.documentElement.dataset.theme);
  await page.getByRole('button', { name: 'Views' }).click();
  await page.getByRole('button', { name: 'Light or dark' }).click();
  const chosen = await theme();
  expect(['light', 'dark']).toContain(chosen);
  await openPage(page);
  expect(await theme()).toBe(chosen);
});
