// A press acts on what was typed, chosen and clicked before it, although the solver has not answered
// yet; an answer that is out of date is not shown.

import { constraintCount, downloaded, openGrid, openText, showStep } from '../actions.ts';
import { holdingAnswers } from '../answers.ts';
import { wavyGrid } from '../meshes.ts';
import { filesOf } from '../sheets.ts';
import {
  expect,
  hold,
  known,
  middleOf,
  openPage,
  sceneOf,
  screenOf,
  settled,
  state,
  test,
  waitForState,
} from '../support.ts';

const N = 6;
const SIDE = N + 1;
/** The vertex in column x and row y. */
const vertex = (x: number, y: number) => y * SIDE + x;
/** The corners of the face whose lower left corner is in column x and row y. */
const cornersOf = (x: number, y: number) => [
  ...[vertex(x, y), vertex(x + 1, y)],
  ...[vertex(x + 1, y + 1), vertex(x, y + 1)],
];

test.describe('in one document', () => {
  test.use({ sameDocument: true });

  test('parts saved at once after a setting was typed have it', async ({ page }) => {
    await openPage(page);
    await openText(page, 'roof.obj', `# units: m\n${wavyGrid(4)}`, 25);
    await showStep(page, 'Shape');
    await page.getByRole('button', { name: 'Build', exact: true }).click();
    await waitForState(page, (now) => now.build !== null);
    const panel = page.getByRole('region', { name: 'Build: parts and sheets' });
    const save = panel.getByRole('button', { name: 'Save drawings and tables' });
    const before = filesOf((await downloaded(page, () => save.click())).bytes);
    const scale = panel.getByLabel('Scale 1 :');
    const twice = 2 * Number(await scale.inputValue());
    await scale.fill(String(twice));
    // In one task, as on a large mesh, where the answer takes longer than the way to the button.
    const atOnce = await downloaded(page, () =>
      save.evaluate((button: HTMLElement) => {
        if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
        button.click();
      }),
    );
    await expect.poll(async () => (await sceneOf(page)).build?.scale).toBe(twice);
    const after = filesOf((await downloaded(page, () => save.click())).bytes);
    expect(filesOf(atOnce.bytes)).toEqual(after);
    expect(after).not.toEqual(before);
  });

  test('a scene saved by its key from within a field has what is typed there', async ({ page }) => {
    await openGrid(page, N);
    await showStep(page, 'Check');
    const field = page.getByRole('spinbutton', { name: 'Close weight' });
    await field.fill('7.5');
    const file = await downloaded(page, () => page.keyboard.press('Control+s'));
    expect(JSON.parse(file.text).weights.close).toBe(7.5);
    await expect(field).toBeFocused();
    await expect(field).toHaveValue('7.5');
  });

  test('handles are made of what a double-click selects, however soon', async ({ page }) => {
    await openGrid(page, N);
    const at = await middleOf(page, [vertex(2, 3), vertex(3, 3)]);
    await page
      .getByRole('application', { name: '3D view' })
      .evaluate((view, [clientX, clientY]) => {
        view.dispatchEvent(new MouseEvent('dblclick', { clientX, clientY, bubbles: true }));
        window.dispatchEvent(new KeyboardEvent('keydown', { key: 'h', code: 'KeyH' }));
      }, at);
    // The loop of edges along a row.
    const { handles } = await waitForState(page, (now) => now.handles.length > 0);
    expect(handles.map((handle) => handle.vertex)).toEqual(
      Array.from({ length: SIDE }, (_, x) => vertex(x, 3)),
    );
  });

  test('a handle that a lesson locks is not dragged, and nothing looks moved', async ({ page }) => {
    await openPage(page);
    const middle = vertex(3, 3);
    const text = wavyGrid(N);
    const rows = (letter: string) =>
      text
        .split('\n')
        .filter((row) => row.startsWith(letter))
        .map((row) => row.slice(2).split(' ').map(Number));
    const scene = {
      ...{ format: 'shape-up-scene', version: 1 },
      mesh: {
        positions: rows('v'),
        faces: rows('f').map((face) => face.map((corner) => corner - 1)),
      },
      constraints: [{ kind: 'plane', on: 'faces' }],
      handles: [{ vertices: [middle], weight: 100 }],
      lesson: {
        text: 'Make it flat.',
        goals: [{ measure: 'planarity', at_most: 0.01 }],
        lock: ['handles'],
      },
    };
    await page.evaluate((given) => window.shapeUp.open(given, 'lesson.shapeup.json'), scene);
    await waitForState(page, (now) => now.handles.length === 1);
    await showStep(page, 'Shape');
    await expect(page.getByText('1 handle.', { exact: true })).toBeVisible();
    await expect(page.getByText(/blue handle/).filter({ visible: true })).toHaveCount(0);
    const before = await state(page);
    const [x, y] = await screenOf(page, middle);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 60, y - 40, { steps: 4 });
    const reason = 'Locked by the lesson: the handles stay as they are.';
    await expect(page.getByRole('status')).toHaveText(reason);
    expect((await state(page)).handles).toEqual(before.handles);
    await page.mouse.up();
    await settled(page);
    expect((await state(page)).handles).toEqual(before.handles);
    await expect(page.getByRole('alert')).toBeEmpty();
    // Nor by keys, nor is another one made.
    await page.getByRole('application', { name: '3D view' }).focus();
    await page.keyboard.press('g');
    await page.keyboard.press('Enter');
    await page.keyboard.press('ArrowUp');
    await expect(page.getByRole('status')).toHaveText(reason);
    const [farX, farY] = await screenOf(page, vertex(1, 1));
    await page.keyboard.down('Alt');
    await page.mouse.move(farX, farY);
    await page.mouse.down();
    await page.mouse.move(farX + 30, farY, { steps: 3 });
    await page.mouse.up();
    await page.keyboard.up('Alt');
    await settled(page);
    expect((await state(page)).handles).toEqual(before.handles);
  });
});

test.describe('with answers that come late', () => {
  test.use({ fresh: true });

  test('a constraint added at once after a click is on what was clicked', async ({ page }) => {
    const answers = await holdingAnswers(page);
    await openGrid(page, N);
    await page.keyboard.press('3');
    await page.mouse.click(...(await middleOf(page, cornersOf(4, 4))));
    await waitForState(page, (now) => now.selection.faces.length === 1);
    await showStep(page, 'Shape');
    await page.getByRole('button', { name: 'Add constraint' }).click();
    const dialog = page.getByRole('dialog', { name: 'New constraint' });
    await dialog.getByRole('radio', { name: 'Plane', exact: true }).check();
    await dialog.getByRole('radio', { name: 'whole selection together' }).check();
    await answers.hold('constraintOffers');
    await page.mouse.click(...(await middleOf(page, cornersOf(2, 2))));
    await dialog.getByRole('button', { name: 'Add', exact: true }).click();
    await answers.come('solver: constraintOffers');
    await answers.release();
    await expect(dialog).toBeHidden();
    await expect.poll(() => constraintCount(page)).toBe(1);
    const [{ on }] = (await sceneOf(page)).constraints;
    const vertices = known(on.vertices as number[] | string);
    const listed =
      typeof vertices === 'string'
        ? vertices.split(',').flatMap((part) => {
            const [first, last = first] = part.split('-').map(Number);
            return Array.from({ length: last - first + 1 }, (_, i) => first + i);
          })
        : vertices;
    expect(listed).toEqual(cornersOf(2, 2).toSorted((a, b) => a - b));
  });

  test('the verdict follows a tolerance that is set while another one is answered', async ({
    page,
  }) => {
    const answers = await holdingAnswers(page);
    await openGrid(page, N);
    await page.getByRole('button', { name: 'Make panels circular' }).click();
    const card = page.getByRole('group', { name: 'Panels', exact: true });
    await expect(card).toContainText('panels are circular within 1 mm');
    const tolerance = page.getByLabel('Tolerance');
    const set = async (value: string) => {
      await tolerance.fill(value);
      await tolerance.press('Enter');
    };
    await expect(card).toContainText('Your mesh moved');
    await answers.hold('verdict');
    await set('2');
    await answers.come('solver: verdict');
    await set('3');
    await answers.release();
    await expect(card).toContainText('panels are circular within 3 mm');
  });
});

test.describe('on a slow network', () => {
  test.use({ fresh: true });

  test('the first example does not replace the file that was opened meanwhile', async ({
    page,
  }) => {
    const release = await hold(page, '**/examples/index.json');
    await page.goto('./');
    await page.waitForFunction(() => Boolean(window.shapeUp));
    await openText(page, 'mine.obj', wavyGrid(N), SIDE ** 2);
    const arrived = page.waitForResponse('**/examples/index.json');
    release();
    await arrived;
    // The menu of the examples is filled by the same answer.
    const examples = page.getByRole('menuitem', { includeHidden: true });
    await expect.poll(() => examples.count()).toBeGreaterThan(5);
    await settled(page);
    await page.waitForTimeout(500);
    expect((await state(page)).vertices).toBe(SIDE ** 2);
    await expect(page.getByRole('status')).toContainText('mine.obj');
  });
});
