// Fields, hints and messages say what is, also after a refusal.

import { addConstraint, openGrid, openText, showStep } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { boxOf, expect, openPage, sceneOf, settled, test, waitForState } from '../support.ts';

test.use({ sameDocument: true });

test('a number that is refused does not stay in its field', async ({ page }) => {
  await openGrid(page, 4);
  await addConstraint(page, 'Plane', 'each face');
  const weight = page.getByRole('spinbutton', { name: 'Smooth weight', exact: true });
  const before = await weight.inputValue();
  await weight.fill('1e300');
  await weight.press('Enter');
  await expect(page.getByRole('alert')).toContainText('differ too much from the others');
  await expect(weight).toHaveValue(before);
  // The message goes with the next one that is made.
  await weight.fill('3');
  await weight.press('Enter');
  await expect.poll(async () => (await sceneOf(page)).weights.smooth).toBe(3);
  await expect(page.getByRole('alert')).toBeEmpty();
  await showStep(page, 'Shape');
  const own = page.getByRole('spinbutton', { name: /^Plane.*: weight/ });
  await own.fill('1e300');
  await own.press('Enter');
  await expect(own).toHaveValue('1');
  expect((await sceneOf(page)).constraints[0].weight ?? 1).toBe(1);
});

test('a number that is being typed is not replaced by one that comes meanwhile', async ({
  page,
}) => {
  await openGrid(page, 4);
  const weight = page.getByRole('spinbutton', { name: 'Smooth weight', exact: true });
  const before = await weight.inputValue();
  await weight.fill('7');
  await weight.press('Enter');
  const undo = page.getByRole('button', { name: 'Undo', exact: true });
  await expect(undo).toHaveAttribute('title', /^Undo: Change weights/);
  await weight.selectText();
  await page.keyboard.type('2');
  await undo.dispatchEvent('click');
  await expect(page.getByRole('status')).toHaveText('Undid: Change weights');
  // It used to become the one before, and the next digit another number.
  await page.keyboard.type('5');
  await expect(weight).toHaveValue('25');
  await weight.press('Escape');
  await expect(weight).toHaveValue(before);
});

test('a number that is typed and not entered is not meant for the next model', async ({ page }) => {
  // The first press beside the field made it an edit of the model that had been opened meanwhile.
  await openGrid(page, 4);
  const weight = page.getByRole('spinbutton', { name: 'Smooth weight', exact: true });
  const before = await weight.inputValue();
  await weight.selectText();
  await page.keyboard.type('7');
  await openText(page, 'other.obj', wavyGrid(3), 16);
  await expect(weight).toHaveValue(before);
  await weight.blur();
  // What the press would have sent is done before this.
  await addConstraint(page, 'Plane', 'each face');
  expect((await sceneOf(page)).weights.smooth).toBe(Number(before));
});

test('Within takes the tolerance as it is, not as it was when the row was opened', async ({
  page,
}) => {
  await openGrid(page, 4);
  await addConstraint(page, 'Plane', 'each face');
  await page.getByRole('button', { name: /^Plane.*: parameters/ }).click();
  const tolerance = page.getByRole('spinbutton', { name: 'Tolerance' });
  await tolerance.fill('50');
  await tolerance.press('Enter');
  await expect.poll(async () => (await sceneOf(page)).tolerance).toBe(0.05);
  await page.getByRole('combobox', { name: /: required/ }).selectOption('within');
  await expect
    .poll(async () => (await sceneOf(page)).constraints[0].require)
    .toEqual({ within: 0.05 });
});

test('0 is refused with the reason where numbers are above it', async ({ page }) => {
  await openGrid(page, 4);
  await addConstraint(page, 'Plane', 'each face');
  const refuses = async (name: RegExp | string) => {
    const field = page.getByRole('spinbutton', { name });
    await field.fill('0');
    await field.press('Enter');
    const why = await field.evaluate((one: HTMLInputElement) => one.validationMessage);
    expect(why).toBe('Expected a number above 0.');
    await field.press('Escape');
  };
  await refuses('Tolerance');
  await page.getByRole('button', { name: /^Plane.*: parameters/ }).click();
  await page.getByRole('combobox', { name: /: required/ }).selectOption('within');
  await refuses(/: within$/);
  const [x, y] = await page.evaluate(() => window.shapeUp.screen(12) ?? [0, 0]);
  await page.mouse.dblclick(x, y);
  await expect(page.getByRole('status')).toHaveText('1 handle added');
  await refuses('Weight of the handle');
});

test('what is no decimal number is no tolerance', async ({ page }) => {
  await openGrid(page, 4);
  await addConstraint(page, 'Plane', 'each face');
  const tolerance = page.getByRole('spinbutton', { name: 'Tolerance' });
  for (const typed of ['Infinity', '1e400', '0x10']) {
    await tolerance.fill(typed);
    await tolerance.press('Enter');
    const why = await tolerance.evaluate((field: HTMLInputElement) => field.validationMessage);
    expect(why).toBe(`“${typed}” is not a length. Expected 1.5, 1/3 or +0.5.`);
  }
});

test('numbers are read as people type them, and the arrow keys change them', async ({ page }) => {
  await openGrid(page, 4);
  await addConstraint(page, 'Plane', 'each face');
  const weight = page.getByRole('spinbutton', { name: /^Plane.*: weight/ });
  const inScene = async () => (await sceneOf(page)).constraints[0].weight;
  for (const [typed, value] of [
    ['2,5', 2.5],
    ['1/4', 0.25],
    ['+0.5', 0.75],
    ['1e-3', 0.001],
  ] as const) {
    await weight.fill(typed);
    await weight.press('Enter');
    await expect(weight).toHaveValue(String(value));
    await expect.poll(inScene).toBe(value);
  }
  await weight.press('ArrowUp');
  await expect.poll(inScene).toBe(0.0011);
  for (const refused of ['-1', 'much', '2 cm', '']) {
    await weight.fill(refused);
    await weight.press('Enter');
    await weight.blur();
    await expect(weight).toHaveValue('0.0011');
  }
  // A unit is converted to that of the field.
  const tolerance = page.getByRole('spinbutton', { name: 'Tolerance' });
  await tolerance.fill('2 cm');
  await tolerance.press('Enter');
  await expect(tolerance).toHaveValue('20');
  await expect.poll(async () => (await sceneOf(page)).tolerance).toBe(0.02);
});

test('presses start from what was entered before, although the solver has not answered', async ({
  page,
}) => {
  // With a slow solver most of them started from the same number again.
  await openGrid(page, 4);
  await addConstraint(page, 'Circle', 'each face');
  await page.getByRole('button', { name: /^Circle.*: parameters/ }).click();
  await page.getByLabel(/^Circle.*Radius: kind of value$/).selectOption('number');
  const radius = page.getByRole('spinbutton', { name: /^Circle.*: Radius$/ });
  await radius.fill('1');
  await radius.press('Enter');
  await expect.poll(async () => (await sceneOf(page)).constraints[0].radius).toBe(1);
  await settled(page);
  for (const field of [page.getByRole('spinbutton', { name: /^Circle.*: weight/ }), radius]) {
    await field.evaluate(async (input: HTMLInputElement) => {
      // Answers are tasks, of which none begins before this one has ended.
      const rendered = async () => {
        for (let turn = 0; turn < 20; turn++) await Promise.resolve();
      };
      for (let press = 0; press < 3; press++) {
        input.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowUp', bubbles: true }));
        await rendered();
      }
      for (let entry = 0; entry < 2; entry++) {
        input.value = '+0.5';
        for (const type of ['input', 'change'])
          input.dispatchEvent(new Event(type, { bubbles: true }));
        await rendered();
      }
    });
  }
  await settled(page);
  await expect(radius).toHaveValue('2.3');
  expect((await sceneOf(page)).constraints[0]).toMatchObject({ weight: 5, radius: 2.3 });
});

test('a handle is not made again', async ({ page }) => {
  await openGrid(page, 4);
  const at = await page.evaluate(() => window.shapeUp.screen(12) ?? [0, 0]);
  await page.mouse.dblclick(at[0], at[1]);
  await expect(page.getByRole('status')).toHaveText('1 handle added');
  await page.waitForTimeout(600);
  await page.mouse.dblclick(at[0], at[1]);
  await expect(page.getByRole('status')).toHaveText('1 vertex is already a handle');
});

test('parts are not the next step of a model without faces', async ({ page }) => {
  await openPage(page);
  await openText(page, 'line.obj', 'v 0 0 0\nv 1 0.2 0\nv 2 -0.1 0.3\nv 3 0 0\nl 1 2 3 4\n', 4);
  await page.getByRole('button', { name: 'Add constraint' }).click();
  await page.getByRole('button', { name: 'Add and run' }).click();
  await waitForState(page, (now) => now.converged);
  await expect(page.locator('#hint')).toHaveText(/^Double-click a vertex/);
});

test('the links of an example lead somewhere', async ({ page }) => {
  await openPage(page);
  const links = page.locator('#example-note a');
  // They come with the note, after the page is ready.
  await expect.poll(() => links.count()).toBeGreaterThan(1);
  const addresses = await links.evaluateAll((all) =>
    all.map((one) => (one as HTMLAnchorElement).href),
  );
  for (const address of addresses) expect((await page.request.get(address)).status()).toBe(200);
});

test('a handle that is moved by keys is let go when another model is opened', async ({ page }) => {
  await openGrid(page, 4);
  const [x, y] = await page.evaluate(() => window.shapeUp.screen(12) ?? [0, 0]);
  await page.mouse.click(x, y);
  await page.keyboard.press('h');
  await waitForState(page, (now) => now.handles.length === 1);
  await page.keyboard.press('Enter');
  await page.keyboard.press('ArrowUp');
  await expect(page.locator('#moved')).toBeVisible();
  await page.evaluate((text) => window.shapeUp.open(text, 'other.obj'), wavyGrid(5));
  await waitForState(page, (now) => now.vertices === 36);
  await page.keyboard.press('ArrowUp');
  await expect(page.locator('#moved')).toBeHidden();
  await page.keyboard.press('Escape');
  await expect(page.getByRole('status')).not.toHaveText(/Move cancelled|Handle moved/);
});

test('Escape in a field takes back what was typed there, and not the selection', async ({
  page,
}) => {
  await openGrid(page, 4);
  const [x, y] = await page.evaluate(() => window.shapeUp.screen(12) ?? [0, 0]);
  await page.mouse.click(x, y);
  await waitForState(page, (now) => now.selection.vertices.length === 1);
  const weight = page.getByRole('spinbutton', { name: 'Smooth weight', exact: true });
  await weight.fill('7');
  for (let i = 0; i < 2; i++) await weight.press('Escape');
  await expect(weight).toHaveValue('1');
  await weight.press('Tab');
  await settled(page);
  expect((await sceneOf(page)).weights.smooth).toBe(1);
  await waitForState(page, (now) => now.selection.vertices.length === 1);
});

test('a slider that is held stays where it is when a run ends', async ({ page }) => {
  await openPage(page);
  const slider = page.getByRole('slider', { name: 'Smooth weight, slider' });
  await slider.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await boxOf(slider);
  await page.getByRole('button', { name: 'Run' }).click();
  await page.mouse.move(x + 0.3 * width, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + 0.8 * width, y + height / 2, { steps: 3 });
  const held = await slider.inputValue();
  await waitForState(page, (now) => now.iteration > 0 && !now.running);
  await settled(page);
  await expect(slider).toHaveValue(held);
  await page.mouse.up();
  await expect.poll(async () => (await sceneOf(page)).weights.smooth).toBeGreaterThan(100);
});

test('a slider that comes back to where it was held leaves the weight as it is', async ({
  page,
}) => {
  // Without a change of value there is no event of one in some browsers: the field kept the weight of
  // the slider, which was never set.
  await openGrid(page, 4);
  const weight = page.getByRole('spinbutton', { name: 'Smooth weight', exact: true });
  await weight.fill('7');
  await weight.press('Enter');
  const slider = page.getByRole('slider', { name: 'Smooth weight, slider' });
  await slider.focus();
  await slider.evaluate((input: HTMLInputElement) => {
    input.dispatchEvent(new Event('input', { bubbles: true }));
  });
  await expect(weight).toHaveValue('7.1');
  await slider.blur();
  await expect(weight).toHaveValue('7');
  expect((await sceneOf(page)).weights.smooth).toBe(7);
});

test('the parameters of a new constraint have the unit of the model that comes', async ({
  page,
}) => {
  await openGrid(page, 4);
  await page.getByRole('button', { name: 'Add constraint' }).click();
  const dialog = page.getByRole('dialog', { name: 'New constraint' });
  await dialog.getByRole('radio', { name: 'Line segment', exact: true }).check();
  await dialog.getByRole('combobox', { name: /^Length/ }).selectOption('number');
  const length = dialog.getByRole('group', { name: 'Length' });
  await expect(length.locator('.fields .quiet')).toHaveText('m');
  await page.evaluate((text) => window.shapeUp.open(text), `# units: mm\n${wavyGrid(5)}`);
  await waitForState(page, (now) => now.vertices === 36);
  await dialog.getByRole('combobox', { name: /^Length/ }).selectOption('number');
  await expect(length.locator('.fields .quiet')).toHaveText('mm');
});

test('what a lesson locks is said in words, without a place in the scene file', async ({
  page,
}) => {
  await openGrid(page, 4);
  const scene = await sceneOf(page);
  const goals = [{ measure: 'planarity', at_most: 0.1 }];
  scene.lesson = { text: 'Make them flat.', goals, lock: ['handles', 'weights'] };
  await page.evaluate(
    (text) => window.shapeUp.open(text, 'lesson.shapeup.json'),
    JSON.stringify(scene),
  );
  await waitForState(page, (now) => now.vertices === 25);
  const at = await page.evaluate(() => window.shapeUp.screen(12) ?? [0, 0]);
  await page.mouse.dblclick(at[0], at[1]);
  await expect(page.getByRole('status')).toHaveText(/^Locked by the lesson: the handles/);
  await expect(page.getByRole('alert')).toBeEmpty();
  await page.evaluate(() => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File(['v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n'], 'other.obj'));
    const at = { bubbles: true, clientY: innerHeight - 10 };
    document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, ...at }));
  });
  await expect(page.getByRole('alert')).toHaveText(/^locked by the lesson/);
});

// The tool, and a dialog that is open, would stay in the page of other tests.
test.describe('in a page of its own', () => {
  test.use({ sameDocument: false, fresh: true });

  test('a stroke that began on another mesh leaves the selection of this one', async ({ page }) => {
    await openGrid(page, 12);
    await page.keyboard.press('3');
    await page.keyboard.press('p');
    const [x, y] = await page.evaluate(() => window.shapeUp.screen(160) ?? [0, 0]);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 40, y, { steps: 3 });
    await page.mouse.up();
    await waitForState(page, (now) => now.selection.faces.length > 0);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.evaluate((text) => window.shapeUp.open(text, 'other.obj'), wavyGrid(2));
    await waitForState(page, (now) => now.vertices === 9);
    await page.keyboard.press('Escape');
    await page.mouse.up();
    await waitForState(page, (now) => now.selection.faces.length === 0);
    await expect(page.getByRole('alert')).toBeEmpty();
  });

  test('two quick presses on two buttons open one dialog', async ({ page }) => {
    await openGrid(page, 40);
    await page
      .getByRole('button', { name: 'Share', exact: true })
      .evaluate((share: HTMLElement) => {
        share.click();
        document.querySelector<HTMLElement>('[data-command="export-as"]')?.click();
      });
    await expect(page.getByRole('dialog', { name: 'Share' })).toBeVisible();
    await expect(page.locator('dialog:modal')).toHaveCount(1);
  });
});

test('a slider that is moved and moved back at once leaves the weight as it was', async ({
  page,
}) => {
  // The way back was compared with a document that had not the way there yet, and was not sent.
  await openGrid(page, 4);
  const slider = page.getByRole('slider', { name: 'Smooth weight, slider' });
  const weight = async () => (await sceneOf(page)).weights.smooth;
  const before = await slider.inputValue();
  const old = await weight();
  await slider.evaluate((input: HTMLInputElement) => {
    for (const by of [1, -1]) {
      input.valueAsNumber += by;
      for (const type of ['input', 'change'])
        input.dispatchEvent(new Event(type, { bubbles: true }));
    }
  });
  await settled(page);
  await expect(slider).toHaveValue(before);
  expect(await weight()).toBeCloseTo(old, 6);
});
