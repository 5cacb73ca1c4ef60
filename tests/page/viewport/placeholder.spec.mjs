// The first picture, shown before the page can draw, and the presses made meanwhile.

import { hidePanels } from '../actions.mjs';
import { file, wavyGrid } from '../meshes.mjs';
import { decodePng } from '../picture.mjs';
import { coloursOfView, expect, looks, screenOf, state, test, waitForState } from '../support.mjs';

test.use({ fresh: true });

const viewOf = (page) => page.getByRole('application', { name: '3D view' });

/** Holds requests back; returns a function that releases them. */
async function hold(page, address) {
  let release;
  const released = new Promise((done) => (release = done));
  await page.route(address, async (route) => {
    const response = await route.fetch();
    await released;
    await route.fulfill({ response });
  });
  return release;
}

// Requests may still be held back when a test ends.
test.afterEach(({ page }) => page.unrouteAll({ behavior: 'ignoreErrors' }));

/** Holds back the view's module only. */
const holdView = (page) => hold(page, '**/view-*.wasm');

/** The fraction of pixels that differ clearly, between two heights given as fractions. */
function differing(a, b, [top, bottom]) {
  const rows = [top, bottom].map((part) => Math.round(part * a.height) * a.width * a.channels);
  let count = 0;
  for (let at = rows[0]; at < rows[1]; at += a.channels) {
    const change = [0, 1, 2].map((i) => Math.abs(a.pixels[at + i] - b.pixels[at + i]));
    if (Math.max(...change) > 48) count += 1;
  }
  return count / ((rows[1] - rows[0]) / a.channels);
}

for (const colorScheme of ['light', 'dark']) {
  test(
    `the example is on the screen before it can be drawn, ${colorScheme}`,
    looks,
    async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      const release = await holdView(page);
      await page.goto('./');
      expect(await coloursOfView(page)).toBeGreaterThan(50);
      await waitForState(page, (now) => now.converged);
      await hidePanels(page);
      const still = decodePng(await viewOf(page).screenshot());

      release();
      await expect(page.locator('#first-picture')).toHaveCount(0);
      expect((await state(page)).renderer).not.toBe('none');
      const drawn = decodePng(await viewOf(page).screenshot());
      // Compares the part between the card and the legend. If the pictures were shifted by one
      // pixel, more than a tenth would differ, because of the circles. The ground shadow, ambient
      // occlusion and fainter distant circles, which come with the view, change less.
      expect(differing(still, drawn, [0.16, 0.68])).toBeLessThan(0.09);
    },
  );
}

test('the first picture shows the solved shape, and nothing moves when the solver takes over', async ({
  page,
}) => {
  const releaseScript = await hold(page, '**/*.js');
  const release = await holdView(page);
  await page.goto('./', { waitUntil: 'commit' });
  const panels = page.locator('#first-picture svg:visible > path:not([data-sides])');
  const corners = () =>
    panels.evaluateAll((all) =>
      all.flatMap((panel) => {
        const text = panel.getAttribute('d');
        const places = text.match(/-?[\d.]+/g).map(Number);
        // The build writes each corner relative to the one before.
        if (text.includes('l')) for (let i = 2; i < places.length; i++) places[i] += places[i - 2];
        return places;
      }),
    );
  await expect(panels).not.toHaveCount(0);
  const built = await corners();
  releaseScript();
  const { iteration } = await waitForState(page, (now) => now.converged);
  expect(iteration).toBeGreaterThan(0);
  // The picture is updated after the state, so it shows an earlier iteration at first.
  const farthest = async () => {
    const live = await corners();
    // The build writes whole pixels, the page tenths of a pixel.
    const isDrawn = live.some((at) => !Number.isInteger(at)) && live.length === built.length;
    return isDrawn ? Math.max(...live.map((at, i) => Math.abs(at - built[i]))) : Infinity;
  };
  await expect.poll(farthest).toBeLessThan(0.56);
  release();
});

test('presses made before anything has loaded take effect later', looks, async ({ page }) => {
  const releaseScript = await hold(page, '**/*.js');
  const releaseModules = await hold(page, '**/*.wasm');
  const mesh = page.waitForResponse(/\/examples\/[^/]+\.obj$/);
  await page.goto('./', { waitUntil: 'commit' });
  expect(await coloursOfView(page)).toBeGreaterThan(50);
  // On a phone the tools are in place only once the script has loaded.
  const run = page.getByRole('button', { name: 'Run' });
  const early = await run.isVisible();
  if (early) await run.click();
  releaseScript();
  if (!early) await run.click();
  const said = page.getByRole('status');
  await expect(said).toHaveText('Starts when the model is loaded');
  // Also if the example has loaded and only the solver is missing.
  await (await mesh).finished();
  await expect(said).toHaveText('Starts when the model is loaded');
  releaseModules();
  // A shape that is already exact would leave nothing to run.
  const undo = page.getByRole('button', { name: 'Undo' });
  await expect(undo).toHaveAttribute('title', /^Undo: Run, \d+ iterations/);
  await expect(said).toHaveText(/^Converged after \d+ iterations$/);
});

test('the first picture is removed when another model is opened', async ({ page }) => {
  const release = await holdView(page);
  await page.goto('./');
  await waitForState(page, (now) => now.vertices > 0);
  await expect(page.locator('#first-picture')).toHaveCount(1);
  await hidePanels(page);
  await page.getByLabel('Open file').setInputFiles(file('grid.obj', wavyGrid(4)));
  await waitForState(page, (now) => now.vertices === 25);
  await expect(page.locator('#first-picture')).toHaveCount(0);
  release();
  await waitForState(page, (now) => now.renderer !== 'none');
});

test('a handle can be dragged before anything can draw, and the mesh follows', async ({ page }) => {
  const releaseScript = await hold(page, '**/*.js');
  const release = await holdView(page);
  await page.goto('./', { waitUntil: 'commit' });
  const picture = page.locator('#first-picture svg:visible');
  const grip = picture.locator('g:has(circle.handle)');
  const handle = grip.locator('.handle');
  const target = grip.locator('.target');
  const placeOf = async (dot) => {
    const { x, y, width, height } = await dot.boundingBox();
    return [x + width / 2, y + height / 2];
  };
  // The style sheet selects one of the two pictures.
  await expect(picture).toHaveCount(1);
  const vertex = Number(await grip.getAttribute('data-vertex'));
  const [x, y] = await placeOf(handle);
  const before = await placeOf(target);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y - 60, { steps: 4 });
  // There is only HTML yet: the target moves, and nothing can follow.
  const dragged = await placeOf(target);
  expect(dragged[0] - before[0]).toBeCloseTo(20, 0);
  expect(dragged[1] - before[1]).toBeCloseTo(-60, 0);
  expect(await placeOf(handle)).toEqual([x, y]);

  // Once the solver has loaded the mesh follows in the picture, even after the drag has ended.
  const panel = picture.locator(':scope > path').last();
  const still = await panel.getAttribute('d');
  releaseScript();
  await expect.poll(async () => (await placeOf(handle))[1]).toBeLessThan(y - 5);
  await expect(panel).not.toHaveAttribute('d', still);
  await page.mouse.move(x + 20, y - 80);
  await page.mouse.up();
  await expect(page.getByRole('button', { name: 'Undo' })).toBeEnabled();

  release();
  await expect(page.locator('#first-picture')).toHaveCount(0);
  expect((await screenOf(page, vertex))[1]).toBeLessThan(y - 5);
});
