// Longer stories in a phone's window, where panels are in a sheet and tools are behind "More".
// Behaviour that does not depend on the layout is tested on the desktop.

import {
  addConstraint,
  constraintCount,
  hidePanels,
  openExample,
  openText,
  runToTheEnd,
  showStep,
  tool,
} from '../actions.ts';
import { file, wavyGrid } from '../meshes.ts';
import {
  boxOf,
  expect,
  openPage,
  positionOf,
  screenOf,
  test,
  waitForState,
  windowOf,
} from '../support.ts';

test('colours, a banded legend, and the number of faces within a tolerance', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(6), 49);
  await addConstraint(page, 'Plane', 'each face');
  await runToTheEnd(page);
  // The verdict covers the legend too.
  await page.getByRole('button', { name: 'Dismiss the verdict' }).click();
  await showStep(page, 'Check');
  await page.getByLabel('Colour by').selectOption({ label: 'Edge length change' });
  await hidePanels(page);
  const legend = page.locator('#legend');
  await expect(legend).toContainText('Edge length change');
  await tool(page, 'Fit range');
  await hidePanels(page);
  await showStep(page, 'Check');
  await page.getByLabel('Colours in bands').check();
  await hidePanels(page);
  await expect(legend).toContainText('steps of');

  await showStep(page, 'Check');
  const tolerance = page.getByLabel('Limit', { exact: true });
  await tolerance.fill('1000');
  await tolerance.press('Enter');
  await expect(page.getByTitle('Panels within the tolerance')).toHaveText('36 of 36 within');
});

test.describe('behind tabs', () => {
  test('problems of a file are reported even though no panel is open', async ({ page }) => {
    await openPage(page);
    // Three faces share an edge.
    const fins = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n';
    await openText(page, 'fins.obj', fins, 5);
    const alert = page.getByRole('alert');
    await expect(alert).toContainText(/^\d kinds? of problem, see Open or make: .*edge/);
    await showStep(page, 'Open');
    await expect(page.locator('#import-report').getByText(/problems? in the file/)).toBeVisible();
  });

  test('the selection bar takes one line, and a second one only for the brush', async ({
    page,
  }) => {
    await openPage(page);
    await tool(page, 'Select');
    await page.keyboard.press('Control+a');
    const bar = page.locator('#select-bar');
    await expect(bar.getByRole('button', { name: 'Clear' })).toBeVisible();
    const { x, width, height } = await boxOf(bar);
    expect(height).toBeLessThan(60);
    const views = await boxOf(page.locator('#view-buttons'));
    expect(x + width).toBeLessThanOrEqual(views.x);
    await bar.getByRole('button', { name: 'Paint' }).click();
    expect((await boxOf(bar.getByLabel('Brush radius'))).width).toBeGreaterThan(250);
    expect((await boxOf(bar)).height).toBeLessThan(104);
  });

  test('a constraint is opened and duplicated, a handle is moved by numbers, and both are undone', async ({
    page,
  }) => {
    await openPage(page);
    await openText(page, 'grid.obj', wavyGrid(6), 49);
    await addConstraint(page, 'Plane', 'each face');
    const row = page.getByRole('list', { name: 'Constraints' }).getByRole('listitem');
    await row.getByRole('button', { name: /parameters/ }).click();
    await row.getByRole('button', { name: /duplicate/ }).click();
    await expect(row).toHaveCount(2);
    await hidePanels(page);
    await waitForState(page, (now) => now.renderer.startsWith('web'));
    await page.mouse.click(...(await screenOf(page, 24)));
    await page.keyboard.press('h');
    await waitForState(page, (now) => now.handles.length === 1);
    const [, , before] = await positionOf(page, 24);
    await showStep(page, 'Move');
    const height = page.getByRole('spinbutton', { name: 'Target z' });
    await height.fill(String(before + 1));
    await height.press('Enter');
    await expect.poll(async () => (await positionOf(page, 24))[2]).toBeGreaterThan(before + 0.5);
    await expect(page.getByRole('button', { name: 'Undo' })).toHaveAttribute(
      'title',
      /Move handle/,
    );
    for (let step = 0; step < 3; step++) await tool(page, 'Undo');
    await expect.poll(() => constraintCount(page)).toBe(1);
  });

  test('the gallery leads to an example, and Next to the one after it', async ({ page }) => {
    const examples = await (await page.request.get('examples/index.json')).json();
    const at = examples.findIndex(({ id }: { id: string }) => id === 'fig-05-circular');
    await page.goto('./gallery.html');
    const found = page.getByRole('article');
    const search = page.getByRole('searchbox', { name: 'Search' });
    await search.fill('tetrahedra BAR');
    await expect(found).toHaveCount(1);
    const { width } = windowOf(page);
    const card = await boxOf(found);
    expect(card.x).toBeGreaterThanOrEqual(0);
    expect(card.x + card.width).toBeLessThanOrEqual(width);
    await search.fill('');
    await page.getByRole('link', { name: examples[at].title, exact: true }).click();
    await waitForState(page, (now, count) => now.vertices === count, examples[at].vertices);
    await showStep(page, 'Open');
    const beside = page.getByRole('navigation', { name: 'Examples one by one' });
    await beside.getByRole('link', { name: 'Next' }).click();
    await waitForState(page, (now, count) => now.vertices === count, examples[at + 1].vertices);
  });

  test('a lesson shows a line over the view, which opens its goals', async ({ page }) => {
    await page.goto('./#example=lesson-glass-roof');
    const line = page.getByRole('button', { name: /Lesson: / });
    await expect(line).toHaveText('✗ Lesson: 1 of 2 goals satisfied');
    await runToTheEnd(page);
    await expect(line).toHaveText('✗ Lesson: 0 of 2 goals satisfied');
    await line.click();
    const lesson = page.getByRole('region', { name: 'Lesson' });
    await expect(lesson).toBeInViewport();
    await expect(lesson).toContainText('Make every pane flat to a millimetre');
    // Hidden while the goals themselves are visible.
    await expect(line).toBeHidden();
    await showStep(page, 'Check');
    await expect(line).toBeVisible();
    await hidePanels(page);
    await openExample(page, 'Hypar');
    await expect(line).toBeHidden();
  });

  test('a flat map lies below the model', async ({ page }) => {
    await openPage(page);
    await waitForState(page, (now) => now.renderer.startsWith('web'));
    await openExample(page, 'Hypar');
    await showStep(page, 'Check');
    await page.getByRole('button', { name: 'Flatten' }).click();
    const map = page.getByRole('application', { name: 'Flat map' });
    await expect(map).toBeVisible();
    const whole = await boxOf(page.getByRole('application', { name: '3D view' }));
    const part = await boxOf(map);
    expect(part.width / whole.width).toBeCloseTo(1, 1);
    expect(part.height / whole.height).toBeCloseTo(0.5, 1);
    await page.getByRole('button', { name: 'Back to the model' }).click();
    await expect(map).toBeHidden();
  });
});

test.describe('by touch', () => {
  test.use({ hasTouch: true, isMobile: true });

  test('files are chosen for another surface and for another pose', async ({ page }) => {
    await openPage(page);
    await openText(page, 'grid.obj', wavyGrid(3), 16);
    await addConstraint(page, 'Rigid', 'each face');
    await showStep(page, 'Shape');
    await page.getByText('More settings').click();
    /** Taps the control that opens a file chooser and provides a file. */
    const choose = async (label: string, given: ReturnType<typeof file>) => {
      const pressed = page.locator('label', { has: page.getByLabel(label) });
      await pressed.scrollIntoViewIfNeeded();
      await expect(pressed).toBeInViewport({ ratio: 1 });
      const { height } = await boxOf(pressed);
      expect(height).toBeGreaterThanOrEqual(44);
      const asked = page.waitForEvent('filechooser');
      await pressed.tap();
      await (await asked).setFiles(given);
    };
    const scene = () => page.evaluate(() => window.shapeUp.scene());
    const status = page.getByRole('status');

    const flat = 'v -50 -50 9\nv 50 -50 9\nv 50 50 9\nv -50 50 9\nf 1 2 3 4\n';
    await choose('Fit to another surface', file('ground.obj', flat));
    await expect(status).toHaveText('Vertices stay near ground.obj');
    expect((await scene()).closeness.to.mesh.positions).toHaveLength(4);

    const raised = wavyGrid(3).replace(/^(v .*) \S+$/gm, '$1 2');
    await choose('Take the pose of another file', file('raised.obj', raised));
    await expect(status).toHaveText('Shapes are taken from raised.obj');
    const { pose } = await scene();
    expect(pose.positions.map(([, , z]: number[]) => z)).toEqual(Array(16).fill(2));
    const leave = page.getByRole('button', { name: 'Leave the other pose' });
    await expect(leave).toBeInViewport();
    await leave.tap();
    await expect(leave).toBeHidden();
    expect((await scene()).pose ?? null).toBeNull();
    await hidePanels(page);
    await page.getByRole('button', { name: 'Run' }).tap();
    await expect.poll(async () => (await positionOf(page, 5))[2]).toBeGreaterThan(1);
  });
});
