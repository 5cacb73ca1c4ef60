// Touch: one finger orbits or moves a handle, two pan and zoom, a long press shows the menu.

import type { Page } from '@playwright/test';
import { openText } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import {
  boxOf,
  expect,
  openPage,
  screenOf,
  settled,
  state,
  test,
  waitForState,
} from '../support.ts';

const N = 4;
const VERTICES = (N + 1) ** 2;
const MIDDLE = (VERTICES - 1) / 2;

test.use({ hasTouch: true, isMobile: true });

/** Simulates fingers on the screen by the browser's own touch events. */
async function fingers(page: Page) {
  const devtools = await page.context().newCDPSession(page);
  const send = (
    type: 'touchStart' | 'touchMove' | 'touchEnd' | 'touchCancel',
    points: number[][],
  ) =>
    devtools.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
  return {
    down: (...points: number[][]) => send('touchStart', points),
    up: () => send('touchEnd', []),
    /** As when the system takes over: a notification, or a palm on the screen. */
    cancel: () => send('touchCancel', []),
    /** Moves as fast as a person: a finger at rest would open the menu. */
    swipe: (...places: number[][][]) =>
      Promise.all([
        ...places.map((points, i) => send(i === 0 ? 'touchStart' : 'touchMove', points)),
        send('touchEnd', []),
      ]),
  };
}

test.beforeEach(async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), VERTICES);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
});

test('after a touch that the system cancels, one finger selects as before', async ({ page }) => {
  const touch = await fingers(page);
  const [x, y] = await screenOf(page, MIDDLE);
  await touch.down([x + 60, y]);
  await touch.cancel();
  await touch.down([x, y]);
  await touch.up();
  await waitForState(page, (now) => now.selection.vertices.length === 1);
});

test('a finger adds to the selection once that is asked for', async ({ page }) => {
  const touch = await fingers(page);
  const tap = async (vertex: number) => {
    await touch.down(await screenOf(page, vertex));
    await touch.up();
  };
  const selected = (...vertices: number[]) =>
    waitForState(page, (now, all) => `${now.selection.vertices}` === `${all}`, vertices);
  await tap(MIDDLE);
  await selected(MIDDLE);
  await tap(MIDDLE + 1);
  await selected(MIDDLE + 1);
  const bar = page.getByRole('toolbar', { name: 'Selection' });
  const add = bar.getByRole('button', { name: 'Add to selection' });
  await add.tap();
  await expect(add).toHaveAttribute('aria-pressed', 'true');
  await tap(MIDDLE);
  await selected(MIDDLE + 1, MIDDLE);
  // With the Select tool, the bar still takes one line.
  await bar.getByRole('button', { name: 'Lasso' }).tap();
  await expect(bar.getByRole('button', { name: 'Select through' })).toBeVisible();
  expect((await boxOf(bar)).height).toBeLessThan(60);
});

test('one finger orbits, two pan and zoom', async ({ page }) => {
  const touch = await fingers(page);
  const corners = [0, N, VERTICES - 1];
  const places = () => Promise.all(corners.map((corner) => screenOf(page, corner)));
  const before = await places();
  const [x, y] = await screenOf(page, MIDDLE);
  await touch.swipe([[x, y]], [[x + 30, y]], [[x + 40, y]]);
  await expect.poll(places).not.toEqual(before);
  expect((await state(page)).selection.vertices).toEqual([]);

  const apart = async () => {
    const [a, , b] = await places();
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
  };
  const size = await apart();
  await touch.swipe(
    [
      [x - 30, y],
      [x + 30, y],
    ],
    [
      [x - 26, y],
      [x + 26, y],
    ],
    [
      [x - 22, y],
      [x + 22, y],
    ],
  );
  await expect.poll(apart).toBeLessThan(0.9 * size);

  const [left] = await screenOf(page, MIDDLE);
  await touch.swipe(
    [
      [x - 30, y],
      [x + 30, y],
    ],
    [
      [x - 10, y + 8],
      [x + 50, y + 8],
    ],
    [
      [x + 10, y + 8],
      [x + 70, y + 8],
    ],
  );
  await expect.poll(async () => (await screenOf(page, MIDDLE))[0]).toBeGreaterThan(left + 20);
});

test('a brush stroke that becomes a pinch leaves the selection as it was', async ({ page }) => {
  const touch = await fingers(page);
  const [x, y] = await screenOf(page, MIDDLE);
  await touch.down([x, y]);
  await touch.up();
  const { selection } = await waitForState(page, (now) => now.selection.vertices.length === 1);
  await page.getByRole('application', { name: '3D view' }).focus();
  await page.keyboard.press('p');
  await touch.down([x - 60, y]);
  await waitForState(page, (now) => now.selection.vertices.length === 0);
  await touch.down([x - 60, y], [x + 60, y]);
  await touch.up();
  await settled(page);
  expect((await state(page)).selection).toEqual(selection);
});

test('a long press shows the menu; a handle and its arrows follow a finger', async ({ page }) => {
  const touch = await fingers(page);
  const [x, y] = await screenOf(page, MIDDLE);
  await touch.down([x, y]);
  const menu = page.getByRole('menu', { name: 'What is here' });
  await expect(menu).toBeVisible();
  await touch.up();
  await expect(menu).toBeVisible();
  const item = menu.getByRole('menuitem', { name: 'Make handle' });
  expect((await boxOf(item)).height).toBeGreaterThanOrEqual(44);
  await item.tap();
  await expect(menu).toBeHidden();
  const made = await waitForState(page, (now) => now.handles.length === 1);
  expect(made.handles[0].vertex).toBe(MIDDLE);

  await touch.swipe([[x, y]], [[x + 12, y - 12]], [[x + 20, y - 24]]);
  const moved = await waitForState(
    page,
    (now, from) => now.handles[0].target[0] !== from,
    made.handles[0].target[0],
  );

  let arrow: [number, number] | null = null;
  const look = async () => (arrow = await page.evaluate(() => window.shapeUp.gizmo('z')));
  await expect.poll(look).not.toBeNull();
  const [left, top] = arrow ?? [NaN, NaN];
  // Beside the arrow, as a finger would be.
  await touch.swipe([[left - 14, top]], [[left - 14, top - 15]], [[left - 14, top - 30]]);
  const [before] = moved.handles;
  const lifted = await waitForState(
    page,
    (now, z) => now.handles[0].target[2] > z,
    before.target[2],
  );
  expect(lifted.handles[0].target.slice(0, 2)).toEqual(before.target.slice(0, 2));
});

test('a long press on an icon button shows its name and does not press it', async ({ page }) => {
  const touch = await fingers(page);
  const undo = page.getByRole('button', { name: 'Undo' });
  await page.mouse.dblclick(...(await screenOf(page, MIDDLE)));
  await waitForState(page, (now) => now.handles.length === 1);
  const { x, y, width, height } = await boxOf(undo);
  await touch.down([x + width / 2, y + height / 2]);
  const tip = page.getByRole('tooltip');
  await expect(tip).toHaveText(/^Undo: /);
  await touch.up();
  expect((await state(page)).handles).toHaveLength(1);
  await expect(tip).toBeInViewport({ ratio: 1 });
  await undo.tap();
  await expect(tip).toBeHidden();
  await waitForState(page, (now) => now.handles.length === 0);
});
