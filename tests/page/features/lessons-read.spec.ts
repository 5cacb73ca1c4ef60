// The example lessons, each solved through the page with the controls that its text names.

import type { Page } from '@playwright/test';
import { openExample, runToTheEnd, showStep } from '../actions.ts';
import { expect, openPage, test, waitForState } from '../support.ts';

const lesson = (page: Page) => page.getByRole('region', { name: 'Lesson' });

/** Checks that the text of the lesson has some words, as the names of controls, in this order. */
async function reads(page: Page, ...names: string[]) {
  const text = (await lesson(page).locator('.lesson-text').textContent()) ?? '';
  const instructions = text.slice(text.indexOf('\n1. '));
  let at = 0;
  for (const name of names) {
    const found = instructions.indexOf(name, at);
    expect(found, `${name}, in: ${instructions.slice(at)}`).toBeGreaterThanOrEqual(0);
    at = found + name.length;
  }
}

async function open(page: Page, title: string) {
  await openPage(page);
  await openExample(page, title);
}

/** "Under Shape, press … in the list, and set Required to …": the constraint is met at once. */
async function require(page: Page, kind: string, word: string) {
  await showStep(page, 'Shape');
  const row = page.getByRole('button', { name: new RegExp(`^${kind} on .*: parameters`) });
  if ((await row.getAttribute('aria-expanded')) !== 'true') await row.click();
  await page
    .getByRole('combobox', { name: new RegExp(`^${kind} on .*: required`) })
    .selectOption({ label: word });
  await waitForState(page, (state) => state.converged && !state.running);
}

/** "Set Colour by to …". */
const colourBy = (page: Page, label: string) =>
  page.getByRole('combobox', { name: 'Colour by' }).selectOption({ label });

const expectGoals = (page: Page, words: string) => expect(lesson(page)).toContainText(words);

/** "Press Build": its panel, once it has built. */
async function openBuild(page: Page) {
  await page.getByRole('button', { name: 'Build', exact: true }).click();
  const panel = page.getByRole('region', { name: 'Build: parts and sheets' });
  await expect(panel.getByRole('button', { name: /^Warped beams/ })).toBeVisible();
  return panel;
}

test('Lesson: what a projection is: with less closeness the tiles become squares', async ({
  page,
}) => {
  await open(page, 'Lesson: what a projection is');
  await reads(page, 'Half step', 'Run', 'Close weight');
  const half = page.getByRole('switch', { name: 'Half step' });
  const status = page.getByRole('status');
  await half.click();
  await expect(status).toHaveText(/^Local step done/);
  await half.click();
  await expect(status).toHaveText(/^Global step done/);
  await runToTheEnd(page);
  await expectGoals(page, '1 of 2 goals satisfied');
  const weight = page.getByRole('spinbutton', { name: 'Close weight' });
  await weight.fill('0.01');
  await weight.press('Enter');
  await runToTheEnd(page);
  await expectGoals(page, 'Passed: 2 goals satisfied');
});

test('Lesson: circles: flat panels become circular', async ({ page }) => {
  await open(page, 'Lesson: circles');
  const colours = ['Planarity', 'Circularity'];
  await reads(page, 'Run', 'Colour by', ...colours, 'Make panels circular', 'Moved');
  await runToTheEnd(page);
  for (const measure of colours) await colourBy(page, measure);
  await expectGoals(page, '1 of 2 goals satisfied');
  await page.getByRole('button', { name: 'Make panels circular', exact: true }).first().click();
  await colourBy(page, 'Moved');
  await expectGoals(page, 'Passed: 2 goals satisfied');
});

test('Lesson: lines of curvature: the goals are met with Within, and missed with Exact', async ({
  page,
}) => {
  await open(page, 'Lesson: lines of curvature');
  await expectGoals(page, '1 of 2 goals satisfied');
  await expect(lesson(page)).toContainText('144 panels');
  const colours = ['Off the lines of curvature', 'Circularity'];
  await reads(page, 'Colour by', ...colours, 'Circle', 'Required', 'Within', 'Moved', 'Exact');
  for (const measure of colours) await colourBy(page, measure);
  await require(page, 'Circle', 'Within');
  await colourBy(page, 'Moved');
  await expectGoals(page, 'Passed: 2 goals satisfied');
  await require(page, 'Circle', 'Exact');
  await expectGoals(page, '1 of 2 goals satisfied');
});

test('Lesson: from any surface to panels: new panels meet both goals', async ({ page }) => {
  await open(page, 'Lesson: from any surface to panels');
  await reads(page, 'Run', 'Undo', 'New panels', 'Use these panels', 'Make panels circular');
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

test('Lesson: offsets and beams: beams are flat once panels are exactly circular', async ({
  page,
}) => {
  await open(page, 'Lesson: offsets and beams');
  const rows = ['Warped beams', 'Uneven offset'];
  await reads(page, 'Build', ...rows, 'Run', 'Circle', 'Required', 'Exact');
  const panel = await openBuild(page);
  for (const row of rows) await panel.getByRole('button', { name: new RegExp(`^${row}`) }).click();
  await expectGoals(page, '1 of 2 goals satisfied');
  await runToTheEnd(page);
  await expectGoals(page, '1 of 2 goals satisfied');
  await require(page, 'Circle', 'Exact');
  await expectGoals(page, 'Passed: 2 goals satisfied');
});

test('Lesson: the stiffness of hexagons: the plates become exactly flat', async ({ page }) => {
  await open(page, 'Lesson: the stiffness of hexagons');
  await reads(page, 'Colour by', 'Planarity', 'Run', 'Plane', 'Required', 'Exact');
  await colourBy(page, 'Planarity');
  await runToTheEnd(page);
  await expectGoals(page, '1 of 2 goals satisfied');
  await require(page, 'Plane', 'Exact');
  await expectGoals(page, 'Passed: 2 goals satisfied');
});

test('Lesson: a model of paper: it fits on two sheets at a smaller scale', async ({ page }) => {
  await open(page, 'Lesson: a model of paper');
  await reads(page, 'Run', 'Build', 'Scale', 'Pieces', 'Nets', 'Strips', 'Save drawings');
  await runToTheEnd(page);
  await expectGoals(page, '1 of 2 goals satisfied');
  const panel = await openBuild(page);
  await panel.getByRole('combobox', { name: 'Pieces' }).selectOption({ label: 'Strips' });
  const scale = panel.getByRole('spinbutton', { name: 'Scale 1 :' });
  await scale.fill('100');
  await scale.press('Enter');
  await expectGoals(page, 'Passed: 2 goals satisfied');
  await expect(panel.getByRole('button', { name: 'Save drawings and tables' })).toBeEnabled();
});

test('Lesson: exact, and what is still free: a variation has better corners', async ({ page }) => {
  await open(page, 'Lesson: exact, and what is still free');
  await reads(page, 'Run', 'Colour by', 'Angle error', 'Variations', 'keep');
  await runToTheEnd(page);
  await expectGoals(page, '1 of 2 goals satisfied');
  await colourBy(page, 'Angle error');
  await page.getByRole('button', { name: 'Variations', exact: true }).click();
  const panel = page.getByRole('region', { name: 'Variations' });
  await expect(panel.getByText('Move the sliders')).toBeVisible();
  const slider = panel.getByRole('slider', { name: 'Variation 1', exact: true });
  const keep = panel.getByRole('button', { name: 'Keep', exact: true });
  // One of its ends meets the goal.
  for (const end of ['-100', '100']) {
    await slider.fill(end);
    await expect(keep).toBeEnabled();
    await waitForState(page, (now) => now.exact?.met);
    if ((await lesson(page).textContent())?.includes('Passed')) break;
  }
  await keep.click();
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
