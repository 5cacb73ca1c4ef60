// The list of kinds: each can be added to a suitable mesh and changes something there.

import type { Locator, Page } from '@playwright/test';
import { constraintCount, openGrid, openText, showStep } from '../actions.ts';
import { quadScene, tetScene, triangleScene } from '../meshes.ts';
import {
  boxOf,
  dragVertex,
  drawn,
  expect,
  known,
  LONG,
  openPage,
  screenOf,
  settled,
  state,
  test,
  waitForState,
} from '../support.ts';

test.use({ sameDocument: true });

const MESHES = [
  { name: 'quads', text: quadScene(4), vertices: 25 },
  { name: 'triangles', text: triangleScene(3), vertices: 16 },
  { name: 'tets', text: tetScene(), vertices: 8 },
];

/** What a page whose worker is listened to has. */
interface Listening {
  /** the types of the messages to the worker */
  asked: string[];
}

/** Energies up to this are rounding errors: the meshes have unit edges. */
const NOTHING = 1e-20;

const dialogOf = (page: Page) => page.getByRole('dialog', { name: 'New constraint' });

/** Opens the dialog and waits until its choices have loaded. */
async function openDialog(page: Page) {
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Add constraint' }).click();
  const dialog = dialogOf(page);
  await expect(dialog.getByRole('button', { name: 'Add', exact: true })).toBeEnabled();
  return dialog;
}

/** The names of the radio buttons in a group. */
const namesIn = (dialog: Locator, group: string) =>
  dialog
    .getByRole('group', { name: group, exact: true })
    .getByRole('radio')
    .evaluateAll((radios) => radios.map((radio) => radio.getAttribute('aria-label') ?? ''));

const kindsOf = (page: Page) => page.evaluate(() => window.shapeUp.kinds());

/**
 * Adds a kind with its default parameters at the place of this index; returns the number of places.
 */
async function add(page: Page, name: string, place: number) {
  const dialog = await openDialog(page);
  await dialog.getByRole('radio', { name, exact: true }).check();
  const places = dialog.getByRole('group', { name: 'Where' }).getByRole('radio');
  const count = await places.count();
  await places.nth(place).check();
  await dialog.getByRole('button', { name: 'Add', exact: true }).click();
  await expect(dialog).toBeHidden();
  await expect.poll(() => constraintCount(page)).toBe(1);
  return count;
}

/** Undoes everything, step by step. */
async function undoAll(page: Page) {
  const undo = page.getByRole('button', { name: 'Undo' });
  await expect(undo).toBeEnabled();
  while (await undo.isEnabled()) {
    await page.keyboard.press('Control+z');
    await settled(page);
  }
  await expect.poll(() => constraintCount(page)).toBe(0);
}

/** The shape energy, once the picture is up to date. */
async function shapeEnergy(page: Page) {
  await drawn(page);
  return known((await state(page)).energy).shape;
}

/** Makes a handle of the first visible vertex and drags it away. */
async function pull(page: Page, count: number) {
  const inSight = (v: number) => page.evaluate((one) => window.shapeUp.screen(one) !== null, v);
  for (let v = 0; v < count; v++) {
    if (!(await inSight(v))) continue;
    await page.mouse.dblclick(
      ...known(await page.evaluate((one) => window.shapeUp.screen(one), v)),
    );
    await waitForState(page, (now) => now.handles.length === 1);
    await dragVertex(page, v, [30, -60]);
    return;
  }
}

/**
 * Adds a kind at the first place where it is not already met (any four points lie on a sphere),
 * iterates once, and returns the shape energy before and after.
 */
async function tryKind(page: Page, name: string, mesh: (typeof MESHES)[number]) {
  let places = 1;
  let before = 0;
  for (let place = 0; place < places && before <= NOTHING; place++) {
    if (place > 0) await undoAll(page);
    places = await add(page, name, place);
    before = await shapeEnergy(page);
  }
  if (before <= NOTHING) {
    await pull(page, mesh.vertices);
    before = await shapeEnergy(page);
  }
  const { iteration } = await state(page);
  await page.getByRole('button', { name: 'Step' }).click();
  await waitForState(page, (now, from) => now.iteration > from, iteration);
  const after = known((await state(page)).energy).shape;
  await undoAll(page);
  return { before, after };
}

/** The kinds that are added and iterated: all of them with LONG=1, else some on each of the meshes. */
const isTried = (name: string) =>
  LONG || ['Plane', 'Sphere', 'Equal lengths', 'Tangent incircles', 'Volume'].includes(name);

test('every kind is offered on a suitable mesh, can be added there, and its energy falls', async ({
  page,
}) => {
  if (LONG) test.setTimeout(240_000);
  await openPage(page);
  const labels = (await kindsOf(page)).map((kind) => kind.label);
  const walked = new Set<string>();
  for (const mesh of MESHES) {
    await openText(page, `${mesh.name}.shapeup.json`, mesh.text, mesh.vertices);
    await expect.poll(() => constraintCount(page)).toBe(0);
    const dialog = await openDialog(page);
    const offered = await namesIn(dialog, 'Shape');
    await dialog.getByRole('button', { name: 'Close' }).click();
    for (const name of offered.filter((one) => !walked.has(one))) {
      walked.add(name);
      if (!isTried(name)) continue;
      const { before, after } = await tryKind(page, name, mesh);
      expect(before, `${name} on ${mesh.name} has something to do`).toBeGreaterThan(NOTHING);
      expect(after, `${name} on ${mesh.name}`).toBeLessThan(before);
    }
  }
  expect([...walked].sort()).toEqual([...labels].sort());
});

test('each kind is shown with a drawing and a description, also by keys, and Escape closes the dialog', async ({
  page,
}) => {
  await openPage(page);
  const kinds = await kindsOf(page);
  const dialog = await openDialog(page);
  for (const name of await namesIn(dialog, 'Shape')) {
    const radio = dialog.getByRole('radio', { name, exact: true });
    const kind = known(kinds.find((one) => one.label === name));
    await expect(radio).toHaveAccessibleDescription(kind.summary);
    await radio.check();
    await expect(dialog.locator('.about')).toHaveText(kind.summary);
    const drawing = dialog
      .locator('.tile', { has: page.getByRole('radio', { name, exact: true }) })
      .locator('svg');
    const box = await boxOf(drawing);
    expect(Math.min(box.width, box.height)).toBeGreaterThanOrEqual(40);
    expect(await drawing.locator('.found circle').count()).toBe(kind.sketch.points.length);
  }

  // Arrow keys move through the kinds.
  const names = await namesIn(dialog, 'Shape');
  await dialog.getByRole('radio', { name: names[0], exact: true }).focus();
  await page.keyboard.press('ArrowRight');
  await expect(dialog.getByRole('radio', { name: names[1], exact: true })).toBeChecked();
  // The last one too, which has to be scrolled into view.
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowLeft');
  const last = dialog.getByRole('radio', { name: names.at(-1), exact: true });
  await expect(last).toBeChecked();
  await expect(last).toBeInViewport();
  await page.keyboard.press('Escape');
  await expect(dialog).toBeHidden();
});

test('a kind for certain elements is offered for these only', async ({ page }) => {
  await openPage(page);
  const kinds = await kindsOf(page);
  for (const mesh of MESHES.slice(0, 2)) {
    await openText(page, `${mesh.name}.shapeup.json`, mesh.text, mesh.vertices);
    const dialog = await openDialog(page);
    const offered = await namesIn(dialog, 'Shape');
    for (const name of offered) {
      await dialog.getByRole('radio', { name, exact: true }).check();
      const { elements } = known(kinds.find((one) => one.label === name));
      const ids = await dialog
        .getByRole('group', { name: 'Where' })
        .getByRole('radio')
        .evaluateAll((radios) => radios.map((radio) => radio.id.replace('new-place-each-', '')));
      expect(ids.length).toBeGreaterThan(0);
      if (elements.length > 0) for (const id of ids) expect(elements).toContain(id);
    }
    await dialog.getByRole('button', { name: 'Close' }).click();
  }
});

test('the dialog requests all offers in one message, for any number of kinds and places', async ({
  page,
}) => {
  await page.addInitScript(() => {
    const asked: string[] = [];
    Object.assign(window, { asked });
    const post = Worker.prototype.postMessage as (...message: unknown[]) => void;
    Worker.prototype.postMessage = function (message, ...rest) {
      asked.push(message.name);
      return post.call(this, message, ...rest);
    };
  });
  await openPage(page);
  const dialog = await openDialog(page);
  await dialog.getByRole('radio', { name: 'Circle', exact: true }).check();
  const asked = await page.evaluate(() => {
    const { asked } = window as unknown as Listening;
    return asked.filter((name) => name === 'constraintOffers');
  });
  expect(asked).toHaveLength(1);
});

test('the usual kind is preselected, follows the selection, runs, and is added once by two presses', async ({
  page,
}) => {
  const n = 6;
  await openGrid(page, n);
  const dialog = await openDialog(page);
  const chosen = (group: string) =>
    dialog.getByRole('group', { name: group, exact: true }).getByRole('radio', { checked: true });
  await expect(chosen('Where')).toHaveAccessibleName('each face');
  const whole = known(await chosen('Shape').getAttribute('aria-label'));
  // Selects a patch of faces in the view while the dialog is open beside it.
  await page.keyboard.press('3');
  const at = 3 * (n + 1) + 3;
  const corners = [at, at + 1, at + n + 1, at + n + 2];
  const places = await Promise.all(corners.map((corner) => screenOf(page, corner)));
  const middle = (axis: 0 | 1) => places.reduce((sum, place) => sum + place[axis] / 4, 0);
  await page.mouse.click(middle(0), middle(1));
  await page.keyboard.press('+');
  await waitForState(page, (now) => now.selection.faces.length === 9);
  await expect(chosen('Where')).toHaveAccessibleName('whole selection together');
  await expect(chosen('Shape')).not.toHaveAccessibleName(whole);
  const other = known(await chosen('Shape').getAttribute('aria-label'));
  // Both presses come before the solver has answered.
  await dialog.getByRole('button', { name: 'Add and run' }).evaluate((button: HTMLElement) => {
    button.click();
    button.click();
  });
  await expect(dialog).toBeHidden();
  await waitForState(page, (now) => now.iteration > 0);
  expect(await constraintCount(page)).toBe(1);
  await expect(page.getByRole('list', { name: 'Constraints' })).toContainText(other);
});
