// Use without a pointer: from a file to its export, focus rings, and shortcut keys.

import type { Page } from '@playwright/test';
import { file, wavyGrid } from '../meshes.ts';
import {
  boxOf,
  drawn,
  expect,
  openPage,
  positionOf,
  settled,
  state,
  test,
  visit,
  waitForState,
} from '../support.ts';

const status = (page: Page) => page.getByRole('status');

/** Opens the page and waits until its toolbars respond to arrow keys. */
async function openBars(page: Page) {
  await openPage(page);
  await page.locator('[role=toolbar] [tabindex="0"]').first().waitFor({ state: 'attached' });
}

/** Describes the focused element: its accessible name, tag and focus ring. */
const focused = (page: Page) =>
  page.evaluate(() => {
    // Only a control has labels.
    const at = document.activeElement as HTMLInputElement;
    const shown = at.matches('input[type=file]') ? (at.parentElement as Element) : at;
    const { outlineStyle, outlineWidth } = getComputedStyle(shown);
    const name =
      at.getAttribute('aria-label') ?? at.labels?.[0]?.textContent ?? at.textContent ?? '';
    return {
      id: at.id,
      tag: at.tagName,
      name: name.trim(),
      ring: outlineStyle !== 'none' && parseFloat(outlineWidth) >= 2,
    };
  });

/** Presses Tab until the element of that name has the focus; fails if it is not reached. */
async function tabTo(page: Page, name: RegExp, key = 'Tab') {
  const met = [];
  for (let press = 0; press < 100; press++) {
    await page.keyboard.press(key);
    const at = await focused(page);
    // The focus has left the page at its end and starts again.
    if (at.tag === 'BODY') continue;
    expect(at.ring, `a ring around ${at.name || at.id || at.tag}`).toBe(true);
    if (name.test(at.name)) return at;
    met.push(at.name || at.id || at.tag);
  }
  throw new Error(`${name} is not reached by ${key}, only: ${met.join(', ')}`);
}

/** Moves through a toolbar with the arrow keys. */
async function walkTo(page: Page, name: RegExp) {
  for (let press = 0; press < 40; press++) {
    const at = await focused(page);
    expect(at.ring, `a ring around ${at.name}`).toBe(true);
    if (name.test(at.name)) return;
    await page.keyboard.press('ArrowRight');
  }
  throw new Error(`${name} is not reached by the arrow keys`);
}

const press = (page: Page, ...keys: string[]) =>
  keys.reduce((before, key) => before.then(() => page.keyboard.press(key)), Promise.resolve());

test('an icon button shows its name while it has the focus', async ({ page }) => {
  await openBars(page);
  await tabTo(page, /^(Undo|Run|Help)$/);
  await walkTo(page, /^Help/);
  const tip = page.getByRole('tooltip');
  await expect(tip).toHaveText(/Mouse and keys/);
  await expect(tip).toBeInViewport({ ratio: 1 });
  await page.keyboard.press('Tab');
  await expect(tip.filter({ hasText: /Mouse and keys/ })).toBeHidden();
});

test('a mesh is opened, constrained, solved and exported by keyboard alone', async ({ page }) => {
  await openBars(page);
  await waitForState(page, (now) => now.renderer.startsWith('web'));

  // Open: a key opens the file chooser, and the focus stays where it was.
  const chooser = page.waitForEvent('filechooser');
  await tabTo(page, /^Open file/);
  await page.keyboard.press('Control+o');
  await (await chooser).setFiles(file('roof.obj', wavyGrid(4)));
  await waitForState(page, (now) => now.vertices === 25);
  await expect(status(page)).toHaveText(/^Opened roof\.obj/);
  expect((await focused(page)).name).toMatch(/^Open file/);

  // Select faces with the bar and menu of the tool.
  await press(page, '3', 'Control+a');
  await expect(status(page)).toHaveText('16 faces selected');
  await tabTo(page, /^Box$|select by/i);
  await walkTo(page, /select by/i);
  await page.keyboard.press('Enter');
  await expect(page.getByRole('dialog', { name: 'Select' })).toBeVisible();
  await walkDown(page, /^Faces along the boundary/);
  await page.keyboard.press('Enter');
  await expect(status(page)).toHaveText('12 faces selected');
  await press(page, 'Control+a');

  // Add a constraint.
  const tools = await tabTo(page, /^Add constraint$/, 'Shift+Tab');
  await page.keyboard.press('Enter');
  const dialog = page.getByRole('dialog', { name: 'New constraint' });
  await expect(dialog.getByRole('radio', { checked: true }).first()).toBeFocused();
  await chooseKind(page, 'Plane');
  await tabTo(page, /^whole selection together|^each/);
  await expect(
    dialog.getByRole('radio', { name: 'each selected face', exact: true }),
  ).toBeVisible();
  await chooseRadio(page, 'each selected face');
  await page.keyboard.press('Enter');
  await expect(dialog).toBeHidden();
  await expect.poll(async () => (await state(page)).constraints).toEqual({ plane: 16 });
  // The focus returns to the button that opened the dialog.
  expect((await focused(page)).name).toBe(tools.name);

  // Make a handle of a corner, found by its number of edges, and move it.
  await press(page, '1', 'b', 'Escape');
  await tabTo(page, /^Box$|select by/i);
  await walkTo(page, /select by/i);
  await page.keyboard.press('Enter');
  await walkDown(page, /^By number of edges/);
  await page.keyboard.press('Enter');
  await expect(page.getByRole('spinbutton', { name: 'Edges' })).toBeFocused();
  await press(page, 'Control+a');
  await page.keyboard.type('2');
  await page.keyboard.press('Enter');
  await expect(status(page)).toHaveText('4 vertices selected');
  await page.keyboard.press('h');
  await expect(status(page)).toHaveText('4 handles added');
  await press(page, 'Escape', 'g');
  const { selection } = await waitForState(page, (now) => now.selection.vertices.length === 1);
  const [corner] = selection.vertices;
  const before = await positionOf(page, corner);
  await tabTo(page, /^3D view$/);
  await press(page, 'Enter', 'z', 'ArrowUp', 'ArrowUp', 'ArrowUp', 'Enter');
  await expect(status(page)).toHaveText('Handle moved');
  const raised = await page.evaluate(
    (v) => window.shapeUp.state().handles.find(({ vertex }) => vertex === v)?.target[2],
    corner,
  );
  expect(raised).toBeGreaterThan(before[2]);

  // Run and read the worst error.
  await page.keyboard.press(' ');
  await expect(status(page)).toHaveText(/^Converged after \d+ iterations/);
  await expect(page.getByText(/^Worst \d/)).toBeVisible();

  // Undo the run, then the move.
  await page.keyboard.press('Control+z');
  await expect(status(page)).toHaveText(/^Undid: Run/);
  await page.keyboard.press('Control+z');
  await expect(status(page)).toHaveText(/^Undid: /);
  await expect.poll(() => positionOf(page, corner)).toEqual(before);

  // Export.
  const download = page.waitForEvent('download');
  await page.keyboard.press('Control+e');
  expect((await download).suggestedFilename()).toBe('roof.obj');
  await expect(status(page)).toHaveText('Saved roof.obj');

  // Share: the link that is copied opens the same scene.
  await tabTo(page, /^Share$/);
  await page.keyboard.press('Enter');
  const share = page.getByRole('dialog', { name: 'Share' });
  await expect(share).toBeVisible();
  await tabTo(page, /^Copy link$/);
  await page.keyboard.press('Enter');
  await expect(share.locator('#share-copied')).not.toBeEmpty();
  const link = await share.getByRole('textbox', { name: 'Link' }).inputValue();
  await page.goto('about:blank');
  await page.goto(link);
  const opened = await waitForState(page, (now) => now.vertices === 25);
  expect(opened.constraints).toEqual({ plane: 16 });
  expect(opened.handles).toHaveLength(4);
});

/** Moves down a menu with the arrow keys. */
async function walkDown(page: Page, name: RegExp) {
  for (let press = 0; press < 40; press++) {
    if (name.test((await focused(page)).name)) return;
    await page.keyboard.press('ArrowDown');
  }
  throw new Error(`${name} is not in the menu`);
}

/** Moves through the focused group of radio buttons. */
async function chooseRadio(page: Page, name: string) {
  for (let press = 0; press < 40; press++) {
    if ((await focused(page)).name === name) return;
    await page.keyboard.press('ArrowDown');
  }
  throw new Error(`${name} cannot be chosen`);
}
const chooseKind = chooseRadio;

test('every tab stop has a focus ring, each toolbar is one stop, and Tab goes all the way round', async ({
  page,
}) => {
  await openBars(page);
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  const stops = [];
  for (let press = 0; press < 90; press++) {
    await page.keyboard.press('Tab');
    const at = await focused(page);
    // After the last stop the focus goes to the browser.
    if (at.tag === 'BODY') break;
    expect(at.ring, `a ring around ${at.name || at.id || at.tag}`).toBe(true);
    stops.push(at.name || at.id);
  }
  expect(stops.length).toBeLessThan(90);
  expect(stops.filter((name) => /^(Run|Step|Undo|Drag|Help)/.test(name))).toHaveLength(1);
  // Backwards too: nothing traps the focus.
  const back = [];
  for (let press = 0; press < stops.length; press++) {
    await page.keyboard.press('Shift+Tab');
    const at = await focused(page);
    if (at.tag === 'BODY') break;
    back.push(at.name || at.id);
  }
  expect(back.length).toBeGreaterThanOrEqual(stops.length - 1);
});

test('arrow keys move through the toolbar, which remembers its position', async ({ page }) => {
  await openBars(page);
  await tabTo(page, /^(Undo|Run|Help)$/);
  await walkTo(page, /^Drag/);
  await page.keyboard.press('End');
  expect((await focused(page)).name).toBe('Help');
  // Wraps around at the end.
  await page.keyboard.press('ArrowRight');
  expect((await focused(page)).name).not.toBe('Help');
  await page.keyboard.press('ArrowLeft');
  expect((await focused(page)).name).toBe('Help');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Shift+Tab');
  expect((await focused(page)).name).toBe('Help');
  // If the button that is the tab stop becomes disabled, another one takes over.
  await walkTo(page, /^Run$/);
  await page.keyboard.press('.');
  await waitForState(page, (now) => now.iteration === 1);
  await walkTo(page, /^Undo$/);
  await page.keyboard.press('Enter');
  await waitForState(page, (now) => now.iteration === 0);
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  await expect(page.locator('#tools :is(button, input)[tabindex="0"]:enabled')).toHaveCount(1);
});

/** Everything that opens: the button, and the role and name of what it opens. */
const OPENING = [
  ['Help', 'dialog', 'Mouse and keys'],
  ['More formats', 'dialog', 'More formats'],
  ['Share', 'dialog', 'Share'],
  ['Examples', 'menu', 'Examples'],
  ['Open recent', 'menu', 'Open recent'],
] as const;
test('Escape closes what was opened and returns the focus to its button', async ({ page }) => {
  await openBars(page);
  for (const [name, role, opens] of OPENING) {
    const opener = page.getByRole('button', { name, exact: true }).filter({ visible: true });
    await opener.focus();
    await page.keyboard.press('Enter');
    const opened = page.getByRole(role, { name: opens });
    await expect(opened).toBeVisible();
    // The focus moves into it.
    await expect
      .poll(() => opened.evaluate((part) => part.contains(document.activeElement)))
      .toBe(true);
    await page.keyboard.press('Escape');
    await expect(opened).toBeHidden();
    await expect(opener).toBeFocused();
  }
});

test('a menu stays at its button and inside the window when the window is resized', async ({
  page,
}) => {
  await openBars(page);
  for (const name of ['Open recent', 'Examples']) {
    await page.setViewportSize({ width: 1440, height: 900 });
    const opener = page.getByRole('button', { name, exact: true });
    await opener.click();
    const menu = page.getByRole('menu', { name });
    await expect(menu).toBeVisible();
    await page.setViewportSize({ width: 1024, height: 600 });
    const isAtIt = async () => {
      const [button, box] = [await boxOf(opener), await boxOf(menu)];
      const below = box.y - (button.y + button.height);
      const isOver = box.x < button.x + button.width && button.x < box.x + box.width;
      const isInside = box.x + box.width <= 1024 && box.y + box.height <= 600;
      return below >= 0 && below < 8 && isOver && isInside;
    };
    await expect.poll(isAtIt).toBe(true);
    await page.keyboard.press('Escape');
  }
});

test('dismissing a hint or message moves the focus to the view', async ({ page }) => {
  await visit(page);
  const view = page.getByRole('application', { name: '3D view' });
  await page.getByRole('button', { name: 'Dismiss hint' }).focus();
  await page.keyboard.press('Enter');
  await expect(view).toBeFocused();
  await page.getByLabel('Open file').setInputFiles(file('house.ifc', 'ISO-10303-21;'));
  await expect(page.getByRole('alert')).toContainText('house.ifc');
  await page.getByRole('button', { name: 'Dismiss', exact: true }).focus();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('alert')).toBeEmpty();
  await expect(view).toBeFocused();
});

test('the focus does not stay in a card that a message hides', async ({ page }) => {
  // It was on the body, without a ring: the next press of Tab began at the top of the page.
  await visit(page);
  const open = page.getByRole('button', { name: 'Open your mesh' });
  await open.focus();
  await page.getByLabel('Open file').setInputFiles(file('house.ifc', 'ISO-10303-21;'));
  await expect(page.getByRole('alert')).toContainText('house.ifc');
  await expect(open).toBeHidden();
  await expect(page.getByRole('application', { name: '3D view' })).toBeFocused();
});

/** A key press on another keyboard layout: the character printed and the key's position. */
const foreign = (
  page: Page,
  key: string,
  code: string,
  modifiers: { ctrlKey?: boolean; shiftKey?: boolean } = {},
) =>
  page.evaluate(
    ([key, code, modifiers]) =>
      document.body.dispatchEvent(
        new KeyboardEvent('keydown', { key, code, bubbles: true, cancelable: true, ...modifiers }),
      ),
    [key, code, modifiers] as const,
  );

test('on a French keyboard letters work by character and digits by key position', async ({
  page,
}) => {
  await openBars(page);
  const pressed = (name: string) =>
    page.locator(`button[data-command="${name}"]`).getAttribute('aria-pressed');
  for (const [key, code, mode] of [
    ['"', 'Digit3', 'mode-faces'],
    ['é', 'Digit2', 'mode-edges'],
    ['&', 'Digit1', 'mode-vertices'],
  ]) {
    await foreign(page, key, code);
    await expect.poll(() => pressed(mode)).toBe('true');
  }
  await page.keyboard.press('.');
  await waitForState(page, (now) => now.iteration === 1);
  // W is where other layouts have Z.
  await foreign(page, 'w', 'KeyZ', { ctrlKey: true });
  await foreign(page, 'z', 'KeyW', { ctrlKey: true });
  await waitForState(page, (now) => now.iteration === 0);
  // On that layout the full stop needs Shift, and the question mark is on another key.
  await foreign(page, '.', 'Comma', { shiftKey: true });
  await waitForState(page, (now) => now.iteration === 1);
  await foreign(page, '?', 'KeyM', { shiftKey: true });
  await expect(page.getByRole('dialog', { name: 'Mouse and keys' })).toBeVisible();
});

test('Home on a slider moves it to its start, and the camera stays', async ({ page }) => {
  await openPage(page);
  await page.getByRole('application', { name: '3D view' }).press('PageUp');
  await drawn(page);
  const camera = await page.evaluate(() => window.shapeUp.camera());
  const slider = page.locator('input[type="range"]:visible').first();
  await slider.press('Home');
  expect(await slider.evaluate((own: HTMLInputElement) => own.value === own.min)).toBe(true);
  await drawn(page);
  expect(await page.evaluate(() => window.shapeUp.camera())).toEqual(camera);
});

test('in a field Ctrl+A selects its text, elsewhere what the tool selects', async ({ page }) => {
  await openPage(page);
  await page.keyboard.press('3');
  const field = page.getByRole('spinbutton').filter({ visible: true }).first();
  await field.focus();
  await page.keyboard.press('Control+a');
  const isAll = (input: HTMLInputElement) =>
    input.value !== '' && input.selectionStart === 0 && input.selectionEnd === input.value.length;
  expect(await field.evaluate(isAll)).toBe(true);
  // The answer to a later request: one to select all would have come before.
  const { iteration } = await state(page);
  await page.getByRole('application', { name: '3D view' }).focus();
  await page.keyboard.press('.');
  await waitForState(page, (now, before) => now.iteration > before, iteration);
  expect((await state(page)).selection.faces).toEqual([]);
  await page.keyboard.press('Control+a');
  await waitForState(page, (now) => now.selection.faces.length === now.faces);
});

test('shortcuts without Ctrl can be switched off, which is remembered', async ({ page }) => {
  await openBars(page);
  await page.keyboard.press('?');
  const single = page.getByRole('checkbox', {
    name: /^Enable single-key shortcuts/,
  });
  await expect(single).toBeChecked();
  await single.uncheck();
  await page.keyboard.press('Escape');
  const selectTool = page.locator('button[data-command="tool-select"]');
  const isOff = async () => {
    await press(page, '.', 'b', '3', '?');
    await settled(page);
    expect((await state(page)).iteration).toBe(0);
    await expect(page.locator('button[data-command="mode-faces"]')).toHaveAttribute(
      'aria-pressed',
      'false',
    );
    await expect(selectTool).toHaveAttribute('aria-pressed', 'false');
    await expect(page.getByRole('dialog')).toBeHidden();
    // No title names a key that does nothing.
    await expect(page.locator('button[data-command="step"]')).toHaveAttribute(
      'title',
      'Step: one iteration',
    );
    await expect(page.getByRole('button', { name: 'Help' })).toHaveAttribute(
      'title',
      'Mouse and keys (F1)',
    );
  };
  await isOff();
  await openBars(page);
  await isOff();
  // Keys that print nothing still work, as do those with Ctrl.
  await page.keyboard.press('F1');
  await expect(single).not.toBeChecked();
  await page.keyboard.press('Escape');
  const download = page.waitForEvent('download');
  await page.keyboard.press('Control+s');
  await download;
});
