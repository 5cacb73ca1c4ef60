// What happens to the open model, and to what is written about it, when another one comes: a file that
// is dropped, or an address.

import type { Page } from '@playwright/test';
import { openText, tool } from '../actions.ts';
import { quadScene, wavyGrid } from '../meshes.ts';
import {
  expect,
  openPage,
  sceneOf,
  settled,
  state,
  test,
  visit,
  waitForState,
} from '../support.ts';

test.use({ fresh: true });

const drop = (page: Page, name: string, text: string) =>
  page.evaluate(
    ([name, text]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], name));
      const at = document.querySelector('dialog:modal') ?? document.body;
      for (const type of ['dragover', 'drop'])
        at.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    },
    [name, text],
  );

/** Changes a weight, which is saved. */
async function changeWeight(page: Page) {
  const weight = page.getByRole('spinbutton', { name: 'Smooth weight', exact: true });
  await weight.fill('7');
  await weight.press('Enter');
  await expect
    .poll(() => page.evaluate(() => document.querySelector('#numbers')?.textContent))
    .toContain('Saved in this browser');
}

/** Opens a roof and changes a weight. */
async function openChanged(page: Page) {
  await visit(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await changeWeight(page);
  await expect.poll(async () => (await sceneOf(page)).weights.smooth).toBe(7);
}

for (const [what, fragment] of [
  ['names nothing', '#nothing'],
  ['is damaged', '#link=AAAA'],
  ['is empty', '#'],
]) {
  test(`an address that ${what} leaves the open work, also after a reload`, async ({ page }) => {
    await openChanged(page);
    await page.evaluate((to) => (location.hash = to), fragment);
    if (fragment.includes('link'))
      await expect(page.getByRole('alert')).toContainText('incomplete or damaged');
    await expect.poll(() => page.evaluate(() => location.hash)).toBe('');
    await page.reload();
    await waitForState(page, (now) => now.vertices > 0);
    expect((await state(page)).vertices).toBe(25);
    expect((await sceneOf(page)).weights.smooth).toBe(7);
  });
}

test('a file that is opened after Undo of a new mesh stays, however long the mesh is asked for', async ({
  page,
}) => {
  await visit(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await tool(page, 'Examples');
  await page.getByRole('menuitem', { name: 'New mesh' }).click();
  const dialog = page.getByRole('dialog', { name: 'New mesh' });
  await dialog.getByRole('button', { name: 'Create mesh' }).click();
  await expect(dialog).toBeHidden();
  // As on a large mesh: the model that is left is asked for, and the answer takes its time.
  await page.evaluate(() => {
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (message, ...rest) {
      const send = () => Reflect.apply(postMessage, this, [message, ...rest]);
      if (message.name === 'rest') Object.assign(window, { letGo: send });
      else send();
    };
  });
  await page.keyboard.press('Control+z');
  await page.waitForFunction(() => 'letGo' in window);
  await openText(page, 'other.obj', wavyGrid(3), 16);
  await page.evaluate(() => (window as unknown as { letGo: () => void }).letGo());
  await page.evaluate(() => window.shapeUp.drawn());
  await page.waitForTimeout(300);
  expect((await state(page)).vertices).toBe(16);
  await expect(page.getByRole('status')).toHaveText(/^Opened other\.obj/);
});

test('work on an example comes back where the list of examples does not', async ({
  page,
  complaints,
}) => {
  await openPage(page);
  await changeWeight(page);
  const { vertices } = await state(page);
  await page.route('**/examples/index.json', (route) => route.abort());
  await page.reload();
  await waitForState(page, (now, count) => now.vertices === count, vertices);
  expect((await sceneOf(page)).weights.smooth).toBe(7);
  // That the list could not be fetched.
  complaints.length = 0;
});

test('a file dropped on a dialog is not opened: what is written there is about the open model', async ({
  page,
}) => {
  await openChanged(page);
  await page.getByRole('button', { name: 'Write a lesson' }).click();
  const dialog = page.getByRole('dialog', { name: 'Lesson' });
  await dialog.getByLabel('Task').fill('Make them flat.');
  await drop(page, 'other.obj', wavyGrid(5));
  await page.waitForTimeout(500);
  expect((await state(page)).vertices).toBe(25);
  await expect(dialog.getByLabel('Task')).toHaveValue('Make them flat.');
  await page.keyboard.press('Escape');
  await drop(page, 'other.obj', wavyGrid(5));
  await waitForState(page, (now) => now.vertices === 36);
});

test('a model that an address opens closes the dialogs about the one before', async ({ page }) => {
  await openChanged(page);
  await tool(page, 'Edit mesh');
  const edit = page.getByRole('dialog', { name: 'Edit mesh' });
  await expect(edit).toBeVisible();
  await page.evaluate(() => (location.hash = '#example=fig-05-circular'));
  await waitForState(page, (now) => now.vertices > 25);
  await expect(edit).toBeHidden();

  // Also that of a new mesh, whose Cancel would bring back the one before.
  await page.getByRole('button', { name: 'Examples' }).click();
  await page.getByRole('menuitem', { name: 'New mesh' }).click();
  const made = page.getByRole('dialog', { name: 'New mesh' });
  await expect(made.getByText(/faces, .* vertices\./)).toBeVisible();
  await page.evaluate(() => (location.hash = '#example=fig-05-planar'));
  await expect(made).toBeHidden();
  await expect(page.getByRole('status')).toHaveText(/^Opened the example/);
  await page.waitForTimeout(500);
  expect(await page.evaluate(() => location.hash)).toBe('#example=fig-05-planar');
});

/** Clicks what is selected as soon as the solver has been asked to open its `nth` model. */
const clickDuringOpening = (page: Page, nth: number, selector: string) =>
  page.addInitScript(
    ([nth, selector]) => {
      let openings = 0;
      window.Worker = class extends Worker {
        override postMessage(
          call: { name: string },
          ...rest: [(Transferable[] | StructuredSerializeOptions)?]
        ) {
          super.postMessage(call, ...(rest as [StructuredSerializeOptions?]));
          if (call.name !== 'open' || ++openings !== nth) return;
          document.querySelector<HTMLElement>(selector)?.click();
        }
      };
    },
    [nth, selector] as const,
  );

test('a dialog begun while the next file is being opened is about that file', async ({ page }) => {
  // The lesson of the next scene was hidden behind a dialog for a lesson of the one before.
  await clickDuringOpening(page, 2, '[data-command="lesson"]');
  await openPage(page);
  const lesson = { text: 'Make it flat.', goals: [{ measure: 'planarity', at_most: 0.01 }] };
  const scene = JSON.stringify({ ...JSON.parse(quadScene(2)), lesson });
  await openText(page, 'lesson.shapeup.json', scene, 9);
  const dialog = page.getByRole('dialog', { name: 'Lesson' });
  await expect(dialog.getByLabel('Task')).toHaveValue('Make it flat.');
});

test('an edit begun while the next file is being opened is not made to that file', async ({
  page,
}) => {
  // The first row of the next scene was switched off.
  await clickDuringOpening(page, 3, '[role="switch"][aria-label$=": on"]');
  await openPage(page);
  const scene = (n: number) =>
    JSON.stringify({ ...JSON.parse(quadScene(n)), constraints: [{ kind: 'plane', on: 'faces' }] });
  await openText(page, 'one.shapeup.json', scene(2), 9);
  await expect(page.getByRole('switch', { name: /: on$/ })).toBeChecked();
  await openText(page, 'two.shapeup.json', scene(3), 16);
  await settled(page);
  expect((await state(page)).constraints.plane).toBe(9);
  await expect(page.getByRole('switch', { name: /: on$/ })).toBeChecked();
  await expect(page.getByRole('alert')).toBeEmpty();
});

test('a reload during the trials of a new mesh brings back the work', async ({ page }) => {
  await openChanged(page);
  await page.getByRole('button', { name: 'Examples' }).click();
  await page.getByRole('menuitem', { name: 'New mesh' }).click();
  const made = page.getByRole('dialog', { name: 'New mesh' });
  await expect(made.getByText(/faces, .* vertices\./)).toBeVisible();
  await page.reload();
  await waitForState(page, (now) => now.vertices > 0);
  expect((await state(page)).vertices).toBe(25);
  expect((await sceneOf(page)).weights.smooth).toBe(7);
  await expect(page.getByRole('alert')).toContainText('roof.obj is back');

  // One that is kept is the work from then on.
  await page.getByRole('button', { name: 'Examples' }).click();
  await page.getByRole('menuitem', { name: 'New mesh' }).click();
  await made.getByRole('button', { name: 'Create mesh' }).click();
  await expect(made).toBeHidden();
  const { vertices } = await state(page);
  expect(vertices).not.toBe(25);
  await expect
    .poll(() => page.evaluate(() => document.querySelector('#numbers')?.textContent))
    .toContain('Saved in this browser');
  await page.reload();
  await waitForState(page, (now, count) => now.vertices === count, vertices);
});

test('a link is followed although the document before it names itself in the address then', async ({
  page,
}) => {
  await openPage(page);
  await page.evaluate(() => {
    const { href } = location;
    location.hash = '#link=CAAqrVip';
    // Before the page is told of the link.
    history.replaceState(null, '', href);
  });
  await expect(page.getByRole('alert')).toContainText('probably truncated');
});
