// The exercise among the examples: found in the gallery, missed, met, handed in, and measured again.

import type { Page } from '@playwright/test';
import { execFile } from 'node:child_process';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { at, program } from '../../../.scripts/project.mjs';
import { downloaded, openExample, runToTheEnd, showStep } from '../actions.ts';
import { expect, openPage, test, waitForState } from '../support.ts';

const ID = 'lesson-glass-roof';
const TITLE = 'Exercise: a glass roof of flat panes';

const lesson = (page: Page) => page.getByRole('region', { name: 'Lesson' });
const goals = (page: Page) =>
  lesson(page).getByRole('list', { name: 'Goals' }).getByRole('listitem');

test('the gallery shows a lesson with its goals, which opens as a lesson', async ({ page }) => {
  await page.goto('./gallery.html');
  await expect(page.getByRole('heading', { name: 'Lessons', level: 2 })).toBeVisible();
  const card = page.getByRole('article', { name: TITLE, exact: true });
  await expect(card).toContainText('Planarity: at most 1 mm');
  await expect(card).toContainText('Distance to original: at most 50 mm');
  // In the order of the course; the exercise comes last.
  await page.getByRole('searchbox', { name: 'Search' }).fill('lesson');
  await expect(page.getByRole('article')).toHaveCount(9);
  await expect(page.getByRole('article', { name: /^Lesson: / })).toHaveCount(8);
  await card.getByRole('link', { name: TITLE }).click();
  await waitForState(page, (now) => now.vertices === 315);
  await showStep(page, 'Shape');
  await expect(lesson(page)).toContainText('Make every pane flat to a millimetre');
  await expect(goals(page)).toHaveCount(2);
});

test('the goals are missed by Run alone, met with the right weights, handed in and checked', async ({
  page,
}) => {
  await openPage(page);
  await openExample(page, TITLE);
  await expect(lesson(page)).toContainText('1 of 2 goals satisfied');
  await expect(goals(page).first()).toContainText(/not satisfied: 9\.\d+ mm/);
  await runToTheEnd(page);
  await expect(lesson(page)).toContainText('0 of 2 goals satisfied');

  const weigh = async (energy: string, value: string) => {
    const field = page.getByRole('spinbutton', { name: energy });
    await field.fill(value);
    await field.press('Enter');
  };
  await weigh('Shape weight', '10000');
  await runToTheEnd(page);
  await expect(lesson(page)).toContainText('1 of 2 goals satisfied');
  await weigh('Close weight', '50');
  await runToTheEnd(page);
  await expect(lesson(page)).toContainText('Passed: 2 goals satisfied');

  await lesson(page).getByRole('button', { name: 'Results for hand-in' }).click();
  const form = page.getByRole('dialog', { name: 'Results for hand-in' });
  await form.getByLabel('Your name').fill('Ada Lovelace');
  const results = await downloaded(page, () =>
    form.getByRole('button', { name: 'Save the file' }).click(),
  );
  expect(results.name).toBe(`${ID}.results.json`);
  expect(JSON.parse(results.text).passed).toBe(true);

  const check = async (text: string) => {
    const file = join(mkdtempSync(join(tmpdir(), 'shape-up-lesson-')), results.name);
    writeFileSync(file, text);
    const words = ['check', file, '--scene', at('dist', 'examples', `${ID}.shapeup.json`)];
    return promisify(execFile)(program, words).then(
      ({ stdout }) => ({ stdout, code: 0 }),
      ({ stdout, stderr, code }) => ({ stdout: stdout + stderr, code }),
    );
  };
  const good = await check(results.text);
  expect(good.code, good.stdout).toBe(0);
  expect(good.stdout).toContain('Ada Lovelace');
  const other = JSON.parse(results.text);
  other.positions[200][2] += 0.2;
  const bad = await check(JSON.stringify(other));
  expect(bad.code, bad.stdout).toBe(1);
  expect(bad.stdout).toContain('not met');
});
