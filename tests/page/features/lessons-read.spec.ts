// An example lesson, done by following its text. That each text leads to its goals is shown natively.

import type { Page } from '@playwright/test';
import { openExample, runToTheEnd, showStep } from '../actions.ts';
import { expect, openPage, test, waitForState } from '../support.ts';

const lesson = (page: Page) => page.getByRole('region', { name: 'Lesson' });

/** "Under Constraints open …, and set Required to …": the constraint is made exact at once. */
async function require(page: Page, kind: string, word: string) {
  await showStep(page, 'Shape');
  const row = page.getByRole('button', { name: new RegExp(`^${kind} on .*: parameters`) });
  if ((await row.getAttribute('aria-expanded')) !== 'true') await row.click();
  await page
    .getByRole('combobox', { name: new RegExp(`^${kind} on .*: required`) })
    .selectOption({ label: word });
  await waitForState(page, (state) => state.converged && !state.running);
}

/** "Under Display colour by …". */
const colourBy = (page: Page, label: string) =>
  page.getByRole('combobox', { name: 'Colour by' }).selectOption({ label });

const expectGoals = (page: Page, words: string) => expect(lesson(page)).toContainText(words);

test('Lesson: curvature and panels: the goals are met with Within, and missed with Exact', async ({
  page,
}) => {
  await openPage(page);
  await openExample(page, 'Lesson: curvature and panels');
  await expectGoals(page, '1 of 2 goals satisfied');
  await expect(lesson(page)).toContainText('144 panels');
  for (const measure of ['Off the lines of curvature', 'Planarity']) await colourBy(page, measure);
  await require(page, 'Plane', 'Within');
  await colourBy(page, 'Moved');
  await expectGoals(page, 'Passed: 2 goals satisfied');
  await require(page, 'Plane', 'Exact');
  await expectGoals(page, '1 of 2 goals satisfied');
});

test('Lesson: from any surface to panels: new panels meet both goals', async ({ page }) => {
  await openPage(page);
  await openExample(page, 'Lesson: from any surface to panels');
  await runToTheEnd(page);
  await showStep(page, 'Shape');
  await expectGoals(page, '1 of 2 goals satisfied');
  await page.getByRole('button', { name: 'Undo' }).click();
  await page.getByRole('button', { name: 'New panels', exact: true }).click();
  const card = page.getByRole('region', { name: 'New panels' });
  await card.getByRole('button', { name: 'Use these panels' }).click();
  await expect(card).toBeHidden();
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Make panels circular' }).first().click();
  await expectGoals(page, 'Passed: 2 goals satisfied');
});

test('locked controls are shown as locked with the reason', async ({ page }) => {
  await openPage(page);
  await openExample(page, 'Lesson: the stiffness of hexagons');
  await expect(lesson(page)).toContainText('Locked: mesh, weights, handles');
  const weight = page.getByRole('spinbutton', { name: 'Close weight' });
  await expect(weight).toBeVisible();
  await expect(weight).toBeDisabled();
  await expect(page.getByText('Locked by the lesson: the weights stay as they are.')).toBeVisible();
  const edit = page.getByRole('button', { name: 'Edit mesh' });
  await expect(edit).toBeDisabled();
  // Its locks would end with the lesson.
  await page.getByRole('button', { name: 'Write a lesson' }).click();
  const remove = page.getByRole('dialog', { name: 'Lesson' }).getByRole('button', {
    name: 'Remove lesson',
  });
  await expect(remove).toBeDisabled();
  await expect(remove).toHaveAttribute('title', /^A lesson with locks stays/);
  await page.keyboard.press('Escape');
  // The lock ends when another scene is opened.
  await openExample(page, 'Hypar of straight beams');
  await expect(weight).toBeEnabled();
  await expect(edit).toBeEnabled();
  await expect(page.getByText('Locked by the lesson').filter({ visible: true })).toHaveCount(0);
});
