// A link contains the scene, which is solved when the link is opened.

import type { Page } from '@playwright/test';
import { addConstraint, openExample, openText, runToTheEnd, showStep, tool } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import {
  dragVertex,
  expect,
  openPage,
  positionOf,
  sceneOf,
  state,
  test,
  waitForState,
} from '../support.ts';

/** Presses Share and returns the link of the dialog, which stays open. */
async function linkOf(page: Page) {
  await tool(page, 'Share');
  const field = page.getByRole('dialog', { name: 'Share' }).getByRole('textbox', { name: 'Link' });
  await expect(field).toBeVisible();
  return field.inputValue();
}

const dialogOf = (page: Page) => page.getByRole('dialog', { name: 'Share' });

/** Opens a link in a new browser context, as another user would. */
async function openElsewhere(otherPage: () => Promise<Page>, link: string) {
  const page = await otherPage();
  await page.goto(link);
  await page.waitForFunction(() => window.shapeUp?.state().vertices > 0);
  return page;
}

test("a link contains the user's mesh, which is solved again", async ({ page, otherPage }) => {
  await openPage(page);
  await openText(page, 'roof.obj', `g east\n${wavyGrid(4)}`, 25);
  await addConstraint(page, 'Plane', 'each face');
  await page.getByLabel('Tolerance').fill('4');
  await page.getByLabel('Tolerance').press('Enter');
  const before = await runToTheEnd(page);
  const within = (there: Page) => there.getByTitle('Panels within the tolerance');
  const link = await linkOf(page);
  expect(new URL(link).hash).toMatch(/^#link=[\w-]+$/);
  await expect(dialogOf(page).getByText('Short enough')).toBeVisible();

  const other = await openElsewhere(otherPage, link);
  const after = await waitForState(other, (now) => now.converged && !now.running);
  expect(after.constraints).toEqual(before.constraints);
  expect(after.iteration).toBe(before.iteration);
  expect(after.energy?.total ?? NaN).toBe(before.energy?.total);
  for (const vertex of [0, 7, 24]) {
    expect(await positionOf(other, vertex)).toEqual(await positionOf(page, vertex));
  }
  expect(await sceneOf(other)).toEqual(await sceneOf(page));
  // The tolerance and the name were those of the reader's page.
  await expect(other.getByLabel('Tolerance')).toHaveValue('4');
  await expect(within(other)).toHaveText((await within(page).textContent()) ?? '');
  await showStep(other, 'Shape');
  await expect(other.getByText('roof.shapeup.json')).toBeVisible();

  // The link stayed in the address, and a reload opened it in place of the later file.
  await openText(other, 'tower.obj', wavyGrid(2), 9);
  expect(new URL(other.url()).hash).toBe('');
  await other.reload();
  await waitForState(other, (now) => now.vertices === 9);
});

test('an example is linked by name, together with its edits', async ({ page, otherPage }) => {
  await openPage(page);
  await openExample(page, 'Hypar');
  const asItCame = (await sceneOf(page)).constraints;
  const plain = await linkOf(page);
  expect(new URL(plain).hash).toBe('#example=hypar');
  await dialogOf(page).getByRole('button', { name: 'Close' }).click();

  await addConstraint(page, 'Plane', 'each face');
  const edited = await linkOf(page);
  expect(new URL(edited).hash).toMatch(/^#link=[\w-]+$/);
  expect(edited.length).toBeLessThan(1000);
  expect((await sceneOf(page)).constraints).not.toEqual(asItCame);

  const other = await openElsewhere(otherPage, edited);
  expect(await sceneOf(other)).toEqual(await sceneOf(page));
  // The same tab opens another link.
  await other.goto(plain);
  await expect.poll(async () => (await sceneOf(other)).constraints).toEqual(asItCame);
});

test('a dragged handle is restored at its target', async ({ page, otherPage }) => {
  await openPage(page);
  const [soft] = (await state(page)).handles.filter((handle) => !handle.fixed);
  await dragVertex(page, soft.vertex, [10, -20]);
  await waitForState(page, (now) => now.iteration > 0);
  const link = await linkOf(page);
  const other = await openElsewhere(otherPage, link);
  expect((await state(other)).handles).toEqual((await state(page)).handles);
});

test('the link is selected and copied', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await openPage(page);
  const link = await linkOf(page);
  await expect(dialogOf(page).getByText('Copied to the clipboard')).toBeVisible();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(link);
  const chosen = await page.evaluate(() => {
    const { value, selectionStart, selectionEnd } = document.activeElement as HTMLInputElement;
    return value.slice(selectionStart ?? 0, selectionEnd ?? 0);
  });
  expect(chosen).toBe(link);
  await page.keyboard.press('Escape');
  await expect(dialogOf(page)).toBeHidden();
});

test('automatic copying fails silently, and the button reports that copying was refused', async ({
  page,
}) => {
  await page.addInitScript(() => {
    navigator.clipboard.writeText = async () => {
      throw new DOMException('Nobody has asked for it.', 'NotAllowedError');
    };
  });
  await openPage(page);
  await linkOf(page);
  await expect(dialogOf(page).getByText('did not allow copying')).toBeHidden();
  await dialogOf(page).getByRole('button', { name: 'Copy link' }).click();
  await expect(dialogOf(page).getByText('did not allow copying')).toBeVisible();
});

test('a long link comes with warnings and an offer to save the scene instead', async ({ page }) => {
  await openPage(page);
  // Without a period, which would be compressed.
  const away = (at: number) => (1 + Math.sin(at * at)) / 4;
  const rough = wavyGrid(40).replace(
    /^v (\S+) (\S+) .*$/gm,
    (_, x, y, at) => `v ${Number(x) + away(at)} ${Number(y) + away(3 * at)} ${away(5 * at)}`,
  );
  await openText(page, 'large.obj', rough, 41 * 41);
  const link = await linkOf(page);
  expect(link.length).toBeGreaterThan(8000);
  await expect(dialogOf(page).getByText('chat programs')).toBeVisible();
  await expect(dialogOf(page).getByText('positions are rounded to')).toBeVisible();
  const download = page.waitForEvent('download');
  await dialogOf(page).getByRole('button', { name: 'Save scene instead' }).click();
  expect((await download).suggestedFilename()).toBe('large.shapeup.json');
});

test('a link that was cut or mistyped is refused with a message, and the page works', async ({
  page,
}) => {
  for (const [hash, words] of [
    ['#link=AaqrVip', 'The link is incomplete or damaged'],
    ['#example=no-such-example', 'The link is outdated or mistyped'],
  ]) {
    await page.goto(`./${hash}`);
    await page.waitForFunction(() => window.shapeUp?.state().vertices > 0);
    await expect(page.getByRole('alert')).toContainText(words);
    await page.goto('about:blank');
  }
});

test('an address without encryption has no clipboard: the button says so', async ({ page }) => {
  await page.addInitScript(() =>
    Object.defineProperty(navigator, 'clipboard', { value: undefined }),
  );
  await openPage(page);
  await linkOf(page);
  await expect(page.getByRole('alert')).toBeEmpty();
  await dialogOf(page).getByRole('button', { name: 'Copy link' }).click();
  await expect(dialogOf(page).getByText('did not allow copying')).toBeVisible();
});
