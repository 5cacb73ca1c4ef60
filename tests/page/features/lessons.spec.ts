// A teacher writes a lesson, a student meets its goals and hands in, and the command line agrees.

import type { Locator, Page } from '@playwright/test';
import { execFile } from 'node:child_process';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { program } from '../../../.scripts/project.mjs';
import { addConstraint, openText, runToTheEnd, showStep } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { expect, openPage, sceneOf, test, waitForState } from '../support.ts';

const N = 6;
const VERTICES = (N + 1) ** 2;
const WORDS = 'Make every panel flat.\nStay near.';

const lesson = (page: Page) => page.getByRole('region', { name: 'Lesson' });
const goals = (page: Page) =>
  lesson(page).getByRole('list', { name: 'Goals' }).getByRole('listitem');

test.beforeEach(async ({ page }) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), VERTICES);
  await addConstraint(page, 'Plane', 'each face');
});

/** The fields of a goal: its measure and its limit. */
const about = (dialog: Locator, goal: number) =>
  dialog.getByRole('combobox', { name: `Goal ${goal}: about`, exact: true });
const most = (dialog: Locator, name: string) =>
  dialog.getByRole('spinbutton', { name, exact: true });

/** Writes a lesson with two goals, up to the last button. */
async function write(page: Page) {
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Write a lesson' }).click();
  const dialog = page.getByRole('dialog', { name: 'Lesson' });
  await dialog.getByLabel('Task').fill(WORDS);
  await about(dialog, 1).selectOption({ label: 'Planarity' });
  await most(dialog, 'Goal 1: planarity at most, mm').fill('5');
  await dialog.getByRole('button', { name: 'Add goal' }).click();
  await about(dialog, 2).selectOption({ label: 'Constraint: Plane' });
  await most(dialog, 'Goal 2: constraint: plane at most, mm').fill('10');
  return dialog;
}

/** Performs `action` and returns the name and text of the file that it saves. */
async function download(page: Page, action: () => unknown) {
  const waiting = page.waitForEvent('download');
  await action();
  const got = await waiting;
  const chunks = [];
  for await (const chunk of await got.createReadStream()) chunks.push(chunk);
  return { name: got.suggestedFilename(), text: Buffer.concat(chunks).toString('utf8') };
}

test('a lesson is written, met, handed in and checked', async ({ page }) => {
  const dialog = await write(page);
  const saved = await download(page, () =>
    dialog.getByRole('button', { name: 'Lesson as a scene file' }).click(),
  );
  expect(JSON.parse(saved.text).lesson).toEqual({
    text: WORDS,
    goals: [
      { measure: 'planarity', at_most: 0.005 },
      { constraint: 'Plane', at_most: 0.01 },
    ],
  });
  await showStep(page, 'Shape');
  await expect(lesson(page)).toContainText('Make every panel flat.');
  await expect(goals(page)).toHaveCount(2);
  await expect(goals(page).first()).toContainText(/at most 5 mm.*not satisfied: /);
  await expect(lesson(page)).toContainText('0 of 2 goals satisfied');
  await runToTheEnd(page);
  await showStep(page, 'Shape');
  await expect(goals(page).first()).toContainText('✓');
  await expect(lesson(page)).toContainText('Passed: 2 goals satisfied');
  // Correcting it used to hand out the shape that the teacher had tried it with.
  await page.getByRole('button', { name: 'Write a lesson' }).click();
  await expect(dialog.getByRole('checkbox', { name: /^Students start/ })).toBeChecked();
  await page.keyboard.press('Escape');

  const handedIn = async () => {
    await showStep(page, 'Shape');
    await lesson(page).getByRole('button', { name: 'Results for hand-in' }).click();
    const form = page.getByRole('dialog', { name: 'Results for hand-in' });
    await form.getByLabel('Your name').fill('Ada Lovelace');
    return download(page, () => form.getByRole('button', { name: 'Save the file' }).click());
  };
  const passed = await handedIn();
  expect(passed.name).toBe('grid.results.json');
  const results = JSON.parse(passed.text);
  expect(results).toMatchObject({ student: 'Ada Lovelace', passed: true });
  expect(results.goals.map(({ met }: { met: boolean }) => met)).toEqual([true, true]);
  expect(results.positions).toHaveLength(VERTICES);

  await page.getByRole('button', { name: 'Reset' }).click();
  await showStep(page, 'Shape');
  await expect(lesson(page)).toContainText('0 of 2 goals satisfied');
  const failed = await handedIn();
  expect(JSON.parse(failed.text).passed).toBe(false);

  // The command line's check of both files.
  const folder = mkdtempSync(join(tmpdir(), 'shape-up-lesson-'));
  const check = async (text: string) => {
    const [file, exercise] = ['results.json', 'scene.json'].map((name) => join(folder, name));
    writeFileSync(file, text);
    writeFileSync(exercise, saved.text);
    const words = ['check', file, '--scene', exercise];
    return promisify(execFile)(program, words).then(
      ({ stdout }) => ({ stdout, code: 0 }),
      ({ stdout, code }) => ({ stdout, code }),
    );
  };
  const good = await check(passed.text);
  expect(good.code, good.stdout).toBe(0);
  expect(good.stdout).toContain('Ada Lovelace');
  const bad = await check(failed.text.replace('"passed": false', '"passed": true'));
  expect(bad.code).toBe(1);
  expect(bad.stdout).toContain('not met');
});

test('the page for teachers is linked, and names controls that are there', async ({ page }) => {
  await page.keyboard.press('?');
  await expect(page.getByRole('link', { name: 'For teachers' })).toBeVisible();
  await page.keyboard.press('Escape');
  const dialog = await write(page);
  const opened = page.waitForEvent('popup');
  await dialog.getByRole('link', { name: 'How to make, hand out and mark a lesson' }).click();
  const guide = await opened;
  await expect(guide.getByRole('heading', { name: 'For teachers', level: 1 })).toBeVisible();
  const names = new Set(await guide.getByRole('main').locator('strong').allInnerTexts());
  expect(names.size).toBeGreaterThan(10);
  await guide.close();
  /** Removes the names that the page shows now, the contents of closed steps included. */
  const find = async () => {
    const text = (await page.locator('body').evaluate((body) => body.textContent)) ?? '';
    for (const name of names) if (text.replace(/\s+/g, ' ').includes(name)) names.delete(name);
  };
  await find();
  await dialog.getByRole('button', { name: 'Save lesson' }).click();
  await showStep(page, 'Shape');
  await lesson(page).getByRole('button', { name: 'Results for hand-in' }).click();
  await expect(page.getByRole('button', { name: 'Save the file' })).toBeVisible();
  await find();
  expect([...names]).toEqual([]);
});

test('a lesson is opened from a link, and undone', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const dialog = await write(page);
  await dialog.getByRole('button', { name: 'Lesson as a link' }).click();
  const share = page.getByRole('dialog', { name: 'Share' });
  const link = await share.getByRole('textbox', { name: 'Link' }).inputValue();
  await share.getByRole('button', { name: 'Close' }).click();

  const student = await context.newPage();
  await student.goto(link);
  await waitForState(student, (now, count) => now.vertices === count, VERTICES);
  await showStep(student, 'Shape');
  await expect(lesson(student)).toContainText('Stay near.');
  await expect(goals(student)).toHaveCount(2);
  await student.close();

  await page.keyboard.press('Control+z');
  await expect(page.getByRole('status')).toHaveText('Undid: Change lesson');
  await expect(lesson(page)).toBeHidden();
  expect((await sceneOf(page)).lesson).toBeUndefined();
});

test('a lesson with a missing limit or without goals is not saved, and can be removed', async ({
  page,
}) => {
  const dialog = await write(page);
  await most(dialog, 'Goal 1: planarity at most, mm').fill('');
  await dialog.getByRole('button', { name: 'Save lesson' }).click();
  await expect(dialog).toBeVisible();
  // The remaining goal becomes the first.
  await dialog.getByRole('button', { name: 'Remove Goal 1: planarity' }).click();
  await about(dialog, 1).selectOption({ label: 'Angle error' });
  await expect(most(dialog, 'Goal 1: angle error at most, °')).toHaveValue('10');
  await dialog.getByRole('button', { name: 'Remove Goal 1: angle error' }).click();
  await dialog.getByRole('button', { name: 'Save lesson' }).click();
  await expect(dialog).toContainText('expected at least one goal');
  await dialog.getByRole('button', { name: 'Add goal' }).click();
  await dialog.getByLabel(/^Goal 1: .* at most/).fill('2');
  await dialog.getByRole('button', { name: 'Save lesson' }).click();
  await expect(dialog).toBeHidden();
  await showStep(page, 'Shape');
  await expect(goals(page)).toHaveCount(1);
  await page.getByRole('button', { name: 'Write a lesson' }).click();
  await expect(dialog.getByLabel('Task')).toHaveValue(WORDS);
  await dialog.getByRole('button', { name: 'Remove lesson' }).click();
  await expect(lesson(page)).toBeHidden();
});

test('a goal on a measure of both signs stays one when the lesson is saved again', async ({
  page,
}) => {
  // It became one on the first measure, with its limit in another unit.
  const scene = await sceneOf(page);
  const goal = { measure: 'mean-curvature', at_most: 0.1 };
  // This one was offered as a length.
  const counted = { measure: 'angles', beyond: 5, at_most: 0 };
  const lesson = { text: WORDS, goals: [goal, counted], lock: [] };
  await page.evaluate((all) => window.shapeUp.open(all, 'lesson.shapeup.json'), {
    ...scene,
    lesson,
  });
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Write a lesson' }).click();
  const dialog = page.getByRole('dialog', { name: 'Lesson' });
  await expect(about(dialog, 2).locator('option:checked')).toHaveText(
    'Panels beyond 5.00°: Angle error',
  );
  await dialog.getByLabel('Task').fill('Another task.');
  await dialog.getByRole('button', { name: 'Save lesson' }).click();
  await expect(dialog).toBeHidden();
  const saved = (await sceneOf(page)).lesson;
  expect(saved.text).toBe('Another task.');
  expect(saved.goals).toEqual([goal, counted]);
});

test('a lesson is corrected without loss of the kept shapes, unless students shall not have them', async ({
  page,
}) => {
  // The box was ticked anew each time, and took the shapes away without a word.
  const scene = await sceneOf(page);
  const { positions } = scene.mesh;
  const kept = ['Start', 'Variation 1'].map((name) => ({ name, positions }));
  const lesson = { text: WORDS, goals: [{ measure: 'planarity', at_most: 0.1 }], lock: [] };
  await page.evaluate((all) => window.shapeUp.open(all, 'lesson.shapeup.json'), {
    ...scene,
    ...{ lesson, variants: { kept, design: 1 } },
  });
  const dialog = page.getByRole('dialog', { name: 'Lesson' });
  const unsolved = dialog.getByRole('checkbox', { name: /^Students start from the original/ });
  const correct = async (words: string) => {
    await showStep(page, 'Shape');
    await page.getByRole('button', { name: 'Write a lesson' }).click();
    await dialog.getByLabel('Task').fill(words);
    await expect(unsolved).not.toBeChecked();
  };
  const save = async () => {
    await dialog.getByRole('button', { name: 'Save lesson' }).click();
    await expect(dialog).toBeHidden();
    const { lesson, variants } = await sceneOf(page);
    return [lesson.text, variants?.kept.length];
  };
  await correct('Another task.');
  expect(await save()).toEqual(['Another task.', 2]);
  await correct('Without them.');
  await unsolved.check();
  await expect(unsolved).toHaveAccessibleName(/; 2 kept shapes are removed$/);
  expect(await save()).toEqual(['Without them.', undefined]);
});

test('a lesson with locks is passed on twice, as a file and as a link', async ({
  page,
  context,
}) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const dialog = await write(page);
  await dialog.getByLabel('Constraints', { exact: true }).check();
  await download(page, () =>
    dialog.getByRole('button', { name: 'Lesson as a scene file' }).click(),
  );
  await expect(dialog).toBeHidden();
  await page.getByRole('button', { name: 'Write a lesson' }).click();
  await dialog.getByRole('button', { name: 'Lesson as a link' }).click();
  const share = page.getByRole('dialog', { name: 'Share' });
  await expect(share.getByRole('textbox', { name: 'Link' })).toHaveValue(/#/);
});
