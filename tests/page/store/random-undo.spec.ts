// Undo over a random sequence of edits: exactly back to the start, and forward again.

import type { Locator, Page } from '@playwright/test';
import { addConstraint, hidePanels, openGrid, showStep } from '../actions.ts';
import {
  dragVertex,
  everything,
  expect,
  known,
  LONG,
  screenOf,
  settled,
  state,
  test,
  waitForState,
} from '../support.ts';

test.use({ sameDocument: true });

const N = 4;
const VERTICES = (N + 1) ** 2;
const DEEDS = LONG ? 60 : 10;

/** Draws a number in [0, limit). */
type Draw = (limit: number) => number;

/** Returns a generator of numbers in [0, limit), the same on every machine for a seed. */
function seeded(seed: number): Draw {
  let now = seed;
  return (limit) => {
    now = (Math.imul(now, 1664525) + 1013904223) >>> 0;
    return Math.floor((now / 2 ** 32) * limit);
  };
}

/** The first visible vertex from a given one on. */
async function seen(page: Page, first: number) {
  for (let i = 0; i < VERTICES; i++) {
    const vertex = (first + i) % VERTICES;
    if (await page.evaluate((v) => window.shapeUp.screen(v), vertex)) return vertex;
  }
  throw new Error('no vertex can be seen');
}

/** User actions, each of which makes one undo step or none. */
const DOINGS: Record<string, (page: Page, draw: Draw) => Promise<void>> = {
  async constrain(page, draw) {
    await addConstraint(page, ['Plane', 'Circle', 'Rectangle'][draw(3)], 'each face');
    await hidePanels(page);
  },
  async weigh(page, draw) {
    const weight = page.getByRole('spinbutton', { name: /: weight$/ });
    if ((await weight.count()) === 0) return;
    await weight.first().fill(String(1 + draw(9)));
    await weight.first().press('Enter');
  },
  async hold(page, draw) {
    await page.mouse.click(...(await screenOf(page, await seen(page, draw(VERTICES)))));
    await page.getByRole('application', { name: '3D view' }).focus();
    await page.keyboard.press('h');
  },
  async pull(page, draw) {
    const { handles } = await state(page);
    if (handles.length === 0) return;
    const { vertex } = handles[draw(handles.length)];
    if (!(await page.evaluate((v) => window.shapeUp.screen(v), vertex))) return;
    await dragVertex(page, vertex, [draw(30) - 15, -5 - draw(20)]);
  },
  async release(page) {
    await page.getByRole('application', { name: '3D view' }).focus();
    await page.keyboard.press('Shift+H');
  },
  async step(page) {
    await page.getByRole('application', { name: '3D view' }).focus();
    await page.keyboard.press('.');
  },
  async reset(page) {
    await page.getByRole('application', { name: '3D view' }).focus();
    await page.keyboard.press('Shift+R');
  },
  async unit(page, draw) {
    await showStep(page, 'Shape');
    await page.getByRole('combobox', { name: 'Unit' }).selectOption(['cm', 'm', 'ft'][draw(3)]);
  },
  async back(page) {
    await page.keyboard.press('Control+z');
  },
  async forward(page) {
    await page.keyboard.press('Control+y');
  },
};

test('a random sequence is undone to the start, each step by its name, and redone', async ({
  page,
}) => {
  await openGrid(page, N);
  const start = await everything(page);
  const draw = seeded(20261120);
  const names = Object.keys(DOINGS);
  const undo = page.getByRole('button', { name: 'Undo' });
  const redo = page.getByRole('button', { name: 'Redo' });

  await DOINGS.constrain(page, draw);
  for (let i = 0; i < DEEDS; i++) {
    await DOINGS[names[draw(names.length)]](page, draw);
    await settled(page);
  }
  // A run is one step, with the number of iterations in its name.
  await page.getByRole('button', { name: 'Run' }).click();
  await expect(undo).toHaveAttribute('title', /Undo: Run, \d+ iterations? /);
  await waitForState(page, (now) => now.converged && !now.running);
  await settled(page);
  const end = await everything(page);

  const through = async (button: Locator, key: string) => {
    const titles = [];
    while (await button.isEnabled()) {
      titles.push(known(await button.getAttribute('title')).replace(/^\w+: | \(.*/g, ''));
      await page.keyboard.press(key);
      await settled(page);
    }
    return titles;
  };
  const undone = await through(undo, 'Control+z');
  expect(undone.length).toBeGreaterThan(3);
  expect(undone.every((name) => name.length > 0)).toBe(true);
  await expect.poll(() => everything(page)).toEqual(start);
  const redone = await through(redo, 'Control+y');
  expect(redone).toEqual(undone.toReversed());
  await expect.poll(() => everything(page)).toEqual(end);
});
