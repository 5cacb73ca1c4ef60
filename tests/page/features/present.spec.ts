// Presentations: steps are made from views, saved in the scene, and shown in order.

import type { Page } from '@playwright/test';
import type { Slide } from '../../../www/pkg/engine/shape_up.js';
import { openText, showStep, tool } from '../actions.ts';
import { file, wavyGrid } from '../meshes.ts';
import { boxOf, expect, openPage, sceneOf, state, test, waitForState } from '../support.ts';

test.use({ sameDocument: true });

const dialogOf = (page: Page) => page.getByRole('dialog', { name: 'Presentation' });
const stageOf = (page: Page) => page.getByRole('region', { name: 'Presentation' });

/** Opens the dialog of the steps. */
async function openSteps(page: Page) {
  await page.getByRole('button', { name: 'Present', exact: true }).click();
  await expect(dialogOf(page)).toBeVisible();
}

/** Makes a roof with two steps, the original and the flat panels, with different measures. */
async function makeSteps(page: Page) {
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(6), 49);
  await page.getByLabel('Colour by').selectOption({ label: 'Planarity' });
  await openSteps(page);
  await dialogOf(page).getByRole('button', { name: 'Add this view' }).click();
  await dialogOf(page).getByLabel('Title of step 1').fill('The design');
  await dialogOf(page).getByLabel('Shape of step 1').selectOption('original');
  await dialogOf(page).getByRole('button', { name: 'Close' }).click();

  await page.getByRole('button', { name: 'Make panels flat' }).click();
  await waitForState(page, (now) => now.converged && !now.running);
  await page.getByLabel('Colour by').selectOption({ label: 'Moved' });
  await page.getByRole('application', { name: '3D view' }).focus();
  await page.keyboard.press('ArrowLeft');
  await openSteps(page);
  await dialogOf(page).getByRole('button', { name: 'Add this view' }).click();
  await dialogOf(page).getByLabel('Title of step 2').fill('Flat panels');
  await dialogOf(page).getByLabel('Text of step 2').fill('Each can be cut from a sheet.');
  // The press that ends the typing changes the step too.
  await dialogOf(page).getByRole('listitem').nth(1).getByLabel('Run').check();
  await expect.poll(async () => (await sceneOf(page)).steps?.[1].run).toBe(true);
}

test('what is docked is not shown to the audience', async ({ page }) => {
  await makeSteps(page);
  await dialogOf(page).getByRole('button', { name: 'Close' }).click();
  await page.getByRole('button', { name: 'Build', exact: true }).click();
  const docked = page.getByRole('region', { name: 'Build: parts and sheets' });
  await expect(docked).toBeVisible();
  await openSteps(page);
  await dialogOf(page).getByRole('button', { name: 'Start', exact: true }).click();
  await expect(stageOf(page)).toBeVisible();
  await expect(docked).toBeHidden();
  await page.keyboard.press('Escape');
  await expect(docked).toBeVisible();
});

test('a title in which nothing has changed in the end belongs to no other step', async ({
  page,
}) => {
  await makeSteps(page);
  // Browsers tell of no change then.
  await dialogOf(page).getByLabel('Title of step 1').press('End');
  await dialogOf(page).getByLabel('Title of step 1').press('s');
  await dialogOf(page).getByLabel('Title of step 1').press('Backspace');
  await dialogOf(page).getByRole('button', { name: 'Remove step 1' }).click();
  await expect(dialogOf(page).getByRole('listitem')).toHaveCount(1);
  await expect(dialogOf(page).getByLabel('Title of step 1')).toHaveValue('Flat panels');
});

test('what is refused in the dialog is said in the dialog', async ({ page }) => {
  // It was behind the dialog, where nothing can be pressed.
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  const scene = await sceneOf(page);
  scene.steps = Array.from({ length: 99 }, (_, k) => ({ title: `Step ${k + 1}` }));
  await page.getByLabel('Open file').setInputFiles(file('full.json', JSON.stringify(scene)));
  await expect(page.getByRole('status')).toContainText('Opened full.json');
  await openSteps(page);
  await dialogOf(page).getByRole('button', { name: 'Add this view' }).click();
  const alert = page.getByRole('alert');
  await expect(dialogOf(page).getByRole('alert')).toContainText('99 at most');
  await dialogOf(page).getByRole('button', { name: 'Dismiss' }).click();
  await expect(alert).toBeEmpty();
  await dialogOf(page).getByRole('button', { name: 'Add this view' }).click();
  await expect(alert).toContainText('99 at most');
  await dialogOf(page).getByRole('button', { name: 'Close' }).click();
  await expect(alert).toBeInViewport({ ratio: 1 });
  await alert.getByRole('button', { name: 'Dismiss' }).click();
  await expect(alert).toBeEmpty();
});

test('steps are shown by buttons and by the keys of a presenter', async ({ page }) => {
  await makeSteps(page);
  const { steps } = await sceneOf(page);
  expect(steps.map(({ title, measure }: Slide) => [title, measure])).toEqual([
    ['The design', 'planarity'],
    ['Flat panels', 'displacement'],
  ]);
  expect(steps[0].original).toBe(true);
  expect(steps[0].camera).not.toEqual(steps[1].camera);

  await dialogOf(page).getByRole('button', { name: 'Start', exact: true }).click();
  const stage = stageOf(page);
  await expect(stage.getByRole('heading', { name: 'The design' })).toBeVisible();
  await expect(stage).toContainText('1 of 2');
  await expect(page.getByRole('banner')).toBeHidden();
  const moved = async () => (await state(page)).moved?.max;
  await expect.poll(moved).toBe(0);
  await expect(stage.getByRole('button', { name: 'Previous' })).toBeDisabled();

  await page.keyboard.press('PageDown');
  await expect(stage.getByRole('heading', { name: 'Flat panels' })).toBeVisible();
  await expect(stage).toContainText('Each can be cut from a sheet.');
  await expect.poll(moved).toBeGreaterThan(0);
  await page.keyboard.press('ArrowLeft');
  await expect(stage).toContainText('1 of 2');
  await expect.poll(moved).toBe(0);
  await stage.getByRole('button', { name: 'Next' }).click();
  await expect(stage).toContainText('2 of 2');
  const isDark = () => stage.evaluate((element) => element.hasAttribute('data-dark'));
  await page.keyboard.press('b');
  expect(await isDark()).toBe(true);
  await page.keyboard.press('b');
  expect(await isDark()).toBe(false);
  // What lies over the model can be put away.
  const heading = stage.getByRole('heading', { name: 'Flat panels' });
  await page.keyboard.press('t');
  await expect(heading).toBeHidden();
  await stage.getByRole('button', { name: 'Title' }).click();
  await expect(heading).toBeVisible();

  await page.keyboard.press('Escape');
  await expect(stage).toHaveCount(0);
  await expect(page.getByRole('banner')).toBeVisible();
  // The presenter's keys are nobody's again.
  const isTaken = await page.evaluate(() => {
    const press = new KeyboardEvent('keydown', { key: 'PageUp', bubbles: true, cancelable: true });
    return !document.body.dispatchEvent(press);
  });
  expect(isTaken).toBe(false);
});

test('the steps are saved in the scene: they can be moved, removed, and undone', async ({
  page,
}) => {
  await makeSteps(page);
  const titles = async () => (await sceneOf(page)).steps?.map(({ title }: Slide) => title) ?? [];
  await dialogOf(page).getByRole('button', { name: 'Step 2 earlier' }).click();
  await expect.poll(titles).toEqual(['Flat panels', 'The design']);
  await dialogOf(page).getByRole('button', { name: 'Remove step 1' }).click();
  await expect.poll(titles).toEqual(['The design']);
  await dialogOf(page).getByRole('button', { name: 'Close' }).click();
  await tool(page, 'Undo');
  await expect.poll(titles).toEqual(['Flat panels', 'The design']);
  const text = await page.evaluate(() => JSON.stringify(window.shapeUp.scene()));
  await page.evaluate((text) => window.shapeUp.open(text, 'again.shapeup.json'), text);
  await expect.poll(titles).toEqual(['Flat panels', 'The design']);
});

test('a presentation ends when its last step is undone', async ({ page }) => {
  // An empty stage said "1 of 0".
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await openSteps(page);
  await dialogOf(page).getByRole('button', { name: 'Add this view' }).click();
  await dialogOf(page).getByRole('button', { name: 'Start', exact: true }).click();
  await expect(stageOf(page)).toContainText('1 of 1');
  await expect(async () => {
    await page.keyboard.press('Control+z');
    await expect(stageOf(page)).toHaveCount(0, { timeout: 500 });
  }).toPass();
});

test('a presentation goes on when a change of the mesh is undone', async ({ page }) => {
  // It ended while the mesh before was on its way.
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await openSteps(page);
  await dialogOf(page).getByRole('button', { name: 'Add this view' }).click();
  await dialogOf(page).getByRole('button', { name: 'Close' }).click();
  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Refine', exact: true }).click();
  await page.getByRole('dialog', { name: 'Refine' }).getByText('Refine now').click();
  await waitForState(page, (now) => now.faces === 64);
  await openSteps(page);
  await dialogOf(page).getByRole('button', { name: 'Start', exact: true }).click();
  await expect(stageOf(page)).toContainText('1 of 1');
  await page.keyboard.press('Control+z');
  await waitForState(page, (now) => now.faces === 16);
  await expect(stageOf(page)).toContainText('1 of 1');
});

test('another view for a step leaves its shape', async ({ page }) => {
  // A step of the original showed the current shape from then on.
  await makeSteps(page);
  const step = dialogOf(page).getByRole('listitem').first();
  await step.getByRole('button', { name: 'Replace by this view' }).click();
  await expect.poll(async () => (await sceneOf(page)).steps?.[0].measure).toBe('displacement');
  expect((await sceneOf(page)).steps?.[0]).toMatchObject({ title: 'The design', original: true });
  await expect(step.getByLabel('Shape of step 1')).toHaveValue('original');
});

test('a step without a shape of its own is called and drawn as it will be shown', async ({
  page,
}) => {
  // It was called the current shape and drawn so, and the audience saw the original.
  await makeSteps(page);
  const shape = dialogOf(page).getByLabel('Shape of step 2');
  await expect(shape.getByRole('option').first()).toHaveText('As the step before leaves it');
  const pictures = () =>
    dialogOf(page)
      .getByRole('img', { name: /Picture of step/ })
      .evaluateAll((all: HTMLCanvasElement[]) => new Set(all.map((one) => one.toDataURL())).size);
  // From the same side.
  const replace = { name: 'Replace by this view' };
  await dialogOf(page).getByRole('button', replace).first().click();
  await expect.poll(pictures).toBe(1);
  await dialogOf(page).getByLabel('Shape of step 1').selectOption('Current shape');
  await dialogOf(page).getByLabel('Shape of step 2').selectOption('original');
  await expect.poll(pictures).toBe(2);
});

/** The colours of each step's picture, as one string per step. */
const picturesOf = (page: Page) =>
  dialogOf(page)
    .getByRole('img', { name: /Picture of step/ })
    .evaluateAll((all: HTMLCanvasElement[]) =>
      all.map((canvas) => {
        const context = canvas.getContext('2d') as CanvasRenderingContext2D;
        const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
        return String(new Uint32Array(data.buffer));
      }),
    );

test('each step has its picture, and notes that are not presented', async ({ page }) => {
  await makeSteps(page);
  const pictures = await picturesOf(page);
  expect(pictures).toHaveLength(2);
  for (const picture of pictures) expect(new Set(picture.split(',')).size).toBeGreaterThan(20);
  expect(pictures[0]).not.toBe(pictures[1]);
  // They were empty when the dialog was opened again.
  await dialogOf(page).getByRole('button', { name: 'Close' }).click();
  await openSteps(page);
  await expect.poll(() => picturesOf(page)).toEqual(pictures);

  const words = 'Ask who has built one.';
  await dialogOf(page).getByLabel('Notes of step 2').fill(words);
  await dialogOf(page).getByLabel('Notes of step 2').blur();
  await expect.poll(async () => (await sceneOf(page)).steps?.[1].notes).toBe(words);
  await dialogOf(page).getByRole('button', { name: 'Start' }).click();
  await page.keyboard.press('PageDown');
  await expect(stageOf(page).getByRole('heading', { name: 'Flat panels' })).toBeVisible();
  await expect(page.getByText(words)).toHaveCount(0);
});

test('Space runs, as the dialog says, also while Next has the focus', async ({ page }) => {
  await makeSteps(page);
  await dialogOf(page).getByRole('button', { name: 'Start', exact: true }).click();
  const stage = stageOf(page);
  await expect(stage).toContainText('1 of 2');
  await expect(stage.getByRole('button', { name: 'Next' })).toBeFocused();
  const { iteration } = await state(page);
  await page.keyboard.press(' ');
  await waitForState(page, (now, before) => now.iteration > before, iteration);
  await expect(stage).toContainText('1 of 2');
});

test('the buttons lie below the view, at its edge', async ({ page }) => {
  // They lay over the mesh, which fills the view.
  await makeSteps(page);
  await dialogOf(page).getByRole('button', { name: 'Start', exact: true }).click();
  const view = await boxOf(page.getByRole('application', { name: '3D view' }));
  for (const name of ['Previous', 'Next', 'Title', 'End']) {
    const button = await boxOf(stageOf(page).getByRole('button', { name }));
    expect(button.y, name).toBeGreaterThanOrEqual(view.y + view.height);
  }
});
