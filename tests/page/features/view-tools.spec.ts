// View tools: views and projection, the ghost of the original and the ground, colour bands, and the
// measuring tape.

import type { Page } from '@playwright/test';
import {
  exported,
  hidePanels,
  openText,
  runToTheEnd,
  showStep,
  addConstraint,
} from '../actions.ts';
import { file, wavyGrid } from '../meshes.ts';
import { decodePng, differingBytes } from '../picture.ts';
import {
  coloursOfView,
  dragVertex,
  expect,
  looks,
  middleOfPicture,
  openPage,
  screenOf,
  seen,
  settled,
  state,
  test,
  waitForState,
} from '../support.ts';

test.use({ sameDocument: true });

/** Two squares side by side, two units wide, the right one three units higher; in metres. */
const STEPS = `# units: m
v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 3 0 3\nv 5 0 3\nv 5 2 3\nv 3 2 3
f 1 2 3 4\nf 5 6 7 8\n`;

const view = (page: Page) => page.getByRole('application', { name: '3D view' });
const tape = (page: Page) => page.getByRole('group', { name: 'Measuring tape' });

/** Opens these squares, without animated views. */
async function openSteps(page: Page, query = '') {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openPage(page, query);
  await openText(page, 'steps.obj', STEPS, 8);
  await screenOf(page, 6);
}

/** The length of an edge on the screen. */
async function seenLength(page: Page, from: number, to: number) {
  const [a, b] = [await screenOf(page, from), await screenOf(page, to)];
  return Math.hypot(b[0] - a[0], b[1] - a[1]);
}

/** Counts the pixels of a PNG that are close to a colour. */
function pixelsOf(bytes: Buffer, [red, green, blue]: number[]) {
  const { pixels, channels } = decodePng(bytes);
  let found = 0;
  for (let at = 0; at < pixels.length; at += channels) {
    const off = [red, green, blue].map((part, i) => Math.abs(part - pixels[at + i]));
    if (Math.max(...off) < 12) found += 1;
  }
  return found;
}

const TAPE = [204, 23, 92];

async function openViews(page: Page) {
  await page.getByRole('button', { name: 'Views' }).click();
  return page.getByRole('dialog', { name: 'Views' });
}

test('views are chosen by keys and menu, at once with reduced motion', async ({ page }) => {
  await openSteps(page);
  await page.keyboard.press('Shift+Digit1');
  await expect(page.getByRole('status')).toHaveText('View: top');
  // From above, right is right, and farther away is higher.
  const [a, b, d] = [await screenOf(page, 0), await screenOf(page, 1), await screenOf(page, 3)];
  expect(Math.abs(a[1] - b[1])).toBeLessThan(1);
  expect(b[0] - a[0]).toBeGreaterThan(20);
  expect(Math.abs(d[0] - a[0])).toBeLessThan(1);
  expect(a[1] - d[1]).toBeGreaterThan(20);

  const menu = await openViews(page);
  await menu.getByRole('button', { name: 'Front' }).click();
  await expect(page.getByRole('status')).toHaveText('View: front');
  await expect
    .poll(async () => (await screenOf(page, 0))[1] - (await screenOf(page, 4))[1])
    .toBeGreaterThan(20);
  for (const name of ['Top', 'Right', 'Back', 'Left', 'Bottom', 'Isometric'])
    await expect(menu.getByRole('button', { name })).toBeVisible();
  await page.keyboard.press('Escape');

  const view = page.getByRole('application', { name: '3D view' });
  await view.focus();
  // With Num Lock, which no test can press.
  await view.dispatchEvent('keydown', { key: '7', code: 'Numpad7' });
  await expect(page.getByRole('status')).toHaveText('View: top');
  // Two vertices are fitted: they are farther apart in the picture.
  const apart = async () => (await screenOf(page, 1))[0] - (await screenOf(page, 0))[0];
  const before = await apart();
  await page.keyboard.press('1');
  await page.mouse.click(...(await screenOf(page, 0)));
  await page.keyboard.down('Shift');
  await page.mouse.click(...(await screenOf(page, 1)));
  await page.keyboard.up('Shift');
  await waitForState(page, (now) => now.selection.vertices.length === 2);
  await page.keyboard.press('f');
  await expect.poll(apart).toBeGreaterThan(1.3 * before);
});

test('a model that is opened again has a camera, which a presentation keeps', async ({ page }) => {
  const camera = () => page.evaluate(() => window.shapeUp.camera());
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
  await expect.poll(camera).not.toBeNull();
  await page.getByLabel('Open file').setInputFiles(file('again.obj', wavyGrid(4)));
  await expect(page.getByRole('status')).toContainText('Opened again.obj');
  // The picture is the same, and so was the camera for the view.
  await expect.poll(camera).not.toBeNull();
});

test('a short animation leads to the view', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await openPage(page);
  await openText(page, 'steps.obj', STEPS, 8);
  await screenOf(page, 0);
  // Asking for a place on the screen would end the way there.
  const frames = page.evaluate(async () => {
    const { requestAnimationFrame: ask } = window;
    let count = 0;
    window.requestAnimationFrame = (draw) => ask(draw) && ++count;
    await new Promise((done) => setTimeout(done, 1000));
    window.requestAnimationFrame = ask;
    return count;
  });
  await page.keyboard.press('Shift+Digit1');
  expect(await frames).toBeGreaterThan(10);
  await expect
    .poll(async () => Math.abs((await screenOf(page, 0))[1] - (await screenOf(page, 1))[1]))
    .toBeLessThan(0.01);
  // The camera is free again.
  const before = await screenOf(page, 0);
  await view(page).focus();
  await page.keyboard.press('PageDown');
  await expect.poll(async () => (await screenOf(page, 0))[0]).not.toBe(before[0]);
});

test('in parallel projection lengths are true, and clicks, wheel and drags work', async ({
  page,
}) => {
  await openSteps(page);
  await page.keyboard.press('Shift+Digit1');
  await expect(page.getByRole('status')).toHaveText('View: top');
  const ratio = async () => (await seenLength(page, 4, 5)) / (await seenLength(page, 0, 1));
  expect(await ratio()).toBeGreaterThan(1.05);
  await page.keyboard.press('5');
  await expect.poll(ratio).toBeCloseTo(1, 3);
  await expect(page.locator('#scale')).toHaveText(/^\d+(\.\d+)? m$/);

  const menu = await openViews(page);
  await expect(menu.getByRole('button', { name: 'Parallel' })).toHaveAttribute(
    'aria-pressed',
    'true',
  );
  await page.keyboard.press('Escape');

  // A click selects the vertex under it.
  await page.mouse.click(...(await screenOf(page, 6)));
  await expect.poll(async () => (await state(page)).selection.vertices).toEqual([6]);
  // The wheel keeps the point under the cursor fixed.
  const at = await screenOf(page, 4);
  await page.mouse.move(...at);
  const long = await seenLength(page, 4, 5);
  await page.mouse.wheel(0, 200);
  await expect.poll(() => seenLength(page, 4, 5)).toBeLessThan(0.9 * long);
  const after = await screenOf(page, 4);
  expect(Math.hypot(after[0] - at[0], after[1] - at[1])).toBeLessThan(2);
  await page.keyboard.press('Home');
  // A drag moves the handle on the screen, at its height.
  await page.keyboard.press('h');
  await waitForState(page, (now) => now.handles.length === 1);
  await dragVertex(page, 6, [-40, 30]);
  await page.waitForFunction(() => Math.abs(window.shapeUp.state().handles[0].target[0] - 5) > 0.1);
  const [handle] = (await state(page)).handles;
  const scale = (await seenLength(page, 0, 1)) / 2;
  expect(handle.target[0]).toBeCloseTo(5 - 40 / scale, 1);
  expect(handle.target[1]).toBeCloseTo(2 - 30 / scale, 1);
  expect(handle.target[2]).toBeCloseTo(3, 5);
});

test('a box in parallel projection selects what is inside', async ({ page }) => {
  await openSteps(page);
  await page.keyboard.press('5');
  await page.keyboard.press('Shift+Digit1');
  await expect(page.getByRole('status')).toHaveText('View: top, parallel');
  const [low, high] = [await screenOf(page, 4), await screenOf(page, 6)];
  await page.keyboard.press('b');
  await page.mouse.move(low[0] - 10, high[1] - 10);
  await page.mouse.down();
  await page.mouse.move(high[0] + 10, low[1] + 10, { steps: 4 });
  await page.mouse.up();
  await expect
    .poll(async () => (await state(page)).selection.vertices.toSorted())
    .toEqual([4, 5, 6, 7]);
});

test('the ghost stays at the original, and the ground shows the scale', looks, async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await addConstraint(page, 'Plane', 'each face');
  await runToTheEnd(page);
  await showStep(page, 'Check');
  const ghost = page.getByLabel('Ghost of the original');
  await ghost.check();
  await page.getByLabel('Ground grid').check();
  await hidePanels(page);
  await expect(page.locator('#scale')).toHaveText(/^Grid /);
  const before = await middleOfPicture(page);
  await page.keyboard.press('o');
  await expect(ghost).not.toBeChecked();
  expect(differingBytes(await middleOfPicture(page), before)).toBeGreaterThan(500);
});

test(
  'colour bands: steps in the legend, and isolines for values at vertices',
  looks,
  async ({ page }) => {
    await openPage(page);
    await openText(page, 'roof.obj', wavyGrid(6), 49);
    await addConstraint(page, 'Plane', 'each face');
    await runToTheEnd(page);
    await showStep(page, 'Check');
    const legend = page.locator('#legend');
    const bands = page.getByLabel('Colours in bands');
    for (const measure of ['Edge length change', 'Moved']) {
      await page.getByLabel('Colour by').selectOption({ label: measure });
      await bands.uncheck();
      await expect(legend).toContainText(measure);
      await expect(legend).not.toContainText('steps of');
      await page.getByRole('button', { name: 'Fit range' }).click();
      const smooth = await middleOfPicture(page);
      await bands.check();
      await expect(legend).toContainText('steps of');
      expect(differingBytes(await middleOfPicture(page), smooth)).toBeGreaterThan(1000);
    }
  },
);

test(
  'the tape measures between two clicked vertices, pictures have it, and Esc removes it',
  looks,
  async ({ page }) => {
    await openSteps(page);
    await page.keyboard.press('d');
    await expect(tape(page)).toContainText('Click two vertices');
    await page.mouse.click(...(await screenOf(page, 0)));
    await expect(tape(page)).toContainText('Click the other vertex');
    await page.mouse.click(...(await screenOf(page, 6)));
    await expect(tape(page)).toContainText('Vertices 0 and 6, in m');
    const row = (name: string) => tape(page).getByRole('row', { name });
    await expect(row('now')).toHaveText('now6.16445.00002.00003.0000');
    await expect(row('original')).toHaveText('original6.16445.00002.00003.0000');
    await expect(page.getByRole('status')).toHaveText('Distance 6.1644 m, originally 6.1644 m');
    // The clicks selected nothing.
    expect((await state(page)).selection.vertices).toEqual([]);

    // An exported picture shows the tape.
    const { bytes } = await seen(page, () => exported(page, 'PNG'));
    expect(pixelsOf(bytes, TAPE)).toBeGreaterThan(20);

    // A double click makes no handle.
    await page.keyboard.press('Shift+Digit1');
    await page.mouse.dblclick(...(await screenOf(page, 6)));
    await settled(page);
    expect((await state(page)).handles).toEqual([]);
    await page.keyboard.press('Escape');
    await expect(tape(page)).toBeHidden();
  },
);

test('the tape measures two selected vertices by keyboard alone', async ({ page }) => {
  await openPage(page);
  await openText(page, 'line.obj', '# units: mm\nv 0 0 0\nv 300 400 0\nl 1 2\n', 2);
  await page.keyboard.press('Control+a');
  await waitForState(page, (now) => now.selection.vertices.length === 2);
  await page.keyboard.press('d');
  await expect(tape(page)).toContainText('in mm');
  await expect(tape(page).getByRole('row', { name: 'now' })).toHaveText(
    'now500.00300.00400.000.00',
  );
  // Both ends are handles; they are moved together, then one of them alone.
  await page.keyboard.press('h');
  await waitForState(page, (now) => now.handles.length === 2);
  await page.keyboard.press('g');
  await waitForState(page, (now) => now.selection.vertices.length === 1);
  await view(page).focus();
  await page.keyboard.press('Enter');
  for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowRight');
  // The mesh follows while the handle is held.
  await expect(tape(page).getByRole('row', { name: 'now' })).not.toHaveText(
    'now500.00300.00400.000.00',
  );
  await page.keyboard.press('Enter');
  await expect(tape(page).getByRole('row', { name: 'original' })).toHaveText(
    'original500.00300.00400.000.00',
  );
  await page.getByRole('button', { name: 'End measuring' }).click();
  await expect(tape(page)).toBeHidden();
});

test(
  'a lost graphics context is restored, with the tape, which opening another model removes',
  looks,
  async ({ page }) => {
    await openSteps(page, 'renderer=webgl2');
    await page.keyboard.press('5');
    await page.keyboard.press('d');
    await page.mouse.click(...(await screenOf(page, 0)));
    await page.mouse.click(...(await screenOf(page, 6)));
    await expect(tape(page)).toContainText('Vertices 0 and 6');
    await page.evaluate(() => {
      const canvas = document.querySelector('[role="application"] canvas') as HTMLCanvasElement;
      canvas.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
      canvas.dataset.lost = 'yes';
    });
    await expect(page.locator('[role="application"] canvas[data-lost]')).toHaveCount(0);
    await waitForState(page, (now) => now.renderer === 'webgl2');
    await expect(page.getByRole('status')).toHaveText('The 3D view was lost and is being restored');
    await expect.poll(() => coloursOfView(page)).toBeGreaterThan(20);
    await expect(tape(page).getByRole('row', { name: 'original' })).toContainText('6.1644');
    await page.keyboard.press('Shift+Digit1');
    const ratio = async () => (await seenLength(page, 4, 5)) / (await seenLength(page, 0, 1));
    await expect.poll(ratio).toBeCloseTo(1, 3);
    await openText(page, 'roof.obj', wavyGrid(4), 25);
    await expect(tape(page)).toBeHidden();
  },
);

test('the original is shown while its key or the Reset button is held', async ({ page }) => {
  await openPage(page);
  await runToTheEnd(page);
  const before = await state(page);
  const vertex = 40;
  const now = await screenOf(page, vertex);
  const seen = () => page.evaluate((v) => window.shapeUp.screen(v), vertex);
  const status = page.getByRole('status');
  const isShown = async () => {
    await expect(status).toHaveText('Showing the original while held');
    expect(await seen()).not.toEqual(now);
  };
  const isOver = async () => {
    await expect(status).not.toHaveText('Showing the original while held');
    expect(await seen()).toEqual(now);
  };

  await view(page).focus();
  await page.keyboard.down('r');
  await isShown();
  await page.keyboard.up('r');
  await isOver();

  const reset = page.getByRole('button', { name: 'Reset' });
  await reset.hover();
  await page.mouse.down();
  await isShown();
  await page.mouse.up();
  await isOver();
  // A long press is no click: nothing was reset.
  await settled(page);
  expect((await state(page)).iteration).toBe(before.iteration);
  // By its key it does what it says, although it was held before.
  await reset.press('Enter');
  await waitForState(page, (later) => later.iteration === 0);
  await runToTheEnd(page);
  await reset.click();
  await waitForState(page, (later) => later.iteration === 0);
});

test('a section plane cuts the model open', looks, async ({ page }) => {
  await openSteps(page);
  await page.keyboard.press('Shift+Digit7');
  await expect(page.getByRole('status')).toHaveText('View: isometric');
  const whole = await middleOfPicture(page);
  const menu = await openViews(page);
  await menu.getByRole('button', { name: 'Section plane' }).click();
  await page.keyboard.press('Escape');
  const card = page.getByRole('group', { name: 'Section' });
  await expect(card).toBeVisible();
  expect(differingBytes(await middleOfPicture(page), whole)).toBeGreaterThan(2000);
  // Halfway along x the right square is cut off and cannot be selected.
  const seen = (vertex: number) => page.evaluate((v) => window.shapeUp.screen(v), vertex);
  expect(await seen(5)).toBeNull();
  expect(await seen(0)).not.toBeNull();
  await card.getByRole('button', { name: 'Other side' }).click();
  await expect.poll(() => seen(5)).not.toBeNull();
  expect(await seen(0)).toBeNull();
  // It ended with every other mesh of the model.
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Refine', exact: true }).click();
  await page
    .getByRole('dialog', { name: 'Refine' })
    .getByRole('button', { name: 'Refine now' })
    .click();
  await waitForState(page, (now) => now.vertices > 8);
  await expect(card).toBeVisible();
  expect(await seen(0)).toBeNull();
  await page.keyboard.press('ControlOrMeta+z');
  await waitForState(page, (now) => now.vertices === 8);
  await card.getByLabel('Section across').selectOption('z');
  await card.getByRole('slider', { name: 'Position of the section' }).fill('0');
  await expect.poll(() => seen(0)).not.toBeNull();
  await card.getByRole('button', { name: 'End the section' }).click();
  await expect(card).toBeHidden();
  expect(differingBytes(await middleOfPicture(page), whole)).toBe(0);
});

test('views are saved with the model and can be restored', async ({ page }) => {
  await openSteps(page);
  await page.keyboard.press('Shift+Digit1');
  await expect(page.getByRole('status')).toHaveText('View: top');
  const above = await screenOf(page, 6);
  let menu = await openViews(page);
  await menu.getByRole('button', { name: 'Keep this view' }).click();
  await menu.getByRole('button', { name: 'Front' }).click();
  await expect.poll(async () => (await screenOf(page, 6))[1]).not.toBeCloseTo(above[1], 0);
  await menu.getByRole('button', { name: 'View 1', exact: true }).click();
  await expect.poll(async () => (await screenOf(page, 6))[1]).toBeCloseTo(above[1], 1);
  await menu.getByRole('button', { name: 'Keep this view' }).click();
  await menu.getByRole('button', { name: 'Remove View 1' }).click();
  await expect(menu.getByRole('button', { name: 'View 1', exact: true })).toBeHidden();
  await expect(menu.getByRole('button', { name: 'View 2', exact: true })).toBeVisible();
  await page.keyboard.press('Escape');
  await openText(page, 'other.obj', wavyGrid(2), 9);
  menu = await openViews(page);
  await expect(menu.getByRole('button', { name: 'View 2', exact: true })).toBeHidden();
});

test('the model turns slowly until the view is touched or another is chosen', async ({ page }) => {
  await openSteps(page);
  let menu = await openViews(page);
  const before = await screenOf(page, 6);
  await menu.getByRole('button', { name: 'Turn slowly' }).click();
  await expect.poll(async () => (await screenOf(page, 6))[0]).not.toBeCloseTo(before[0], 0);
  const rests = async () => {
    const stopped = await screenOf(page, 0);
    await page.waitForTimeout(300);
    expect(await screenOf(page, 0)).toEqual(stopped);
  };
  await view(page).click({ position: { x: 20, y: 300 } });
  await rests();
  menu = await openViews(page);
  await menu.getByRole('button', { name: 'Turn slowly' }).click();
  menu = await openViews(page);
  await menu.getByRole('button', { name: 'Top' }).click();
  await rests();
});
