// One press for all panels: from a file to the verdict, and runs that collapse a mesh.

import type { Page } from '@playwright/test';
import { downloaded, openText, showStep, tool } from '../actions.ts';
import { bumpyGrid, columns, quadScene, steppedGrid, triangleScene, wavyGrid } from '../meshes.ts';
import {
  boxOf,
  expect,
  openPage,
  screenOf,
  settled,
  state,
  test,
  waitForState,
} from '../support.ts';

test.use({ sameDocument: true });

const N = 6;
const VERTICES = (N + 1) ** 2;
const VERDICT = (adjective: string) =>
  new RegExp(
    `^(The surface moved .+ edge\\. )?(All|\\d+ of) ${N * N} panels are ${adjective} within 1 mm\\.$`,
  );

const offer = (page: Page) => page.getByRole('group', { name: 'Panels', exact: true });
const press = (page: Page, adjective: string) =>
  page.getByRole('button', { name: `Make panels ${adjective}`, exact: true });

test('one press makes an opened mesh circular, and a verdict shows how far it moved', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), VERTICES);
  // The cost is shown before the press.
  const forecast =
    /^This mesh will move a little for flat or circular panels \(about [\d.]+ m on average\)\.$/;
  await expect(offer(page).getByText(forecast)).toBeVisible();
  // Each button exists only once.
  await press(page, 'circular').click();
  const verdict = (adjective: string) => offer(page).getByText(VERDICT(adjective));
  await expect(verdict('circular')).toBeVisible();
  const solved = await waitForState(page, (now) => !now.running && now.iteration > 0);
  expect(solved.constraints).toEqual({ circle: N * N });
  // The numbers are in the legend, once.
  await expect(page.getByText(/^Worst [\d.]+ mm\s+Moved [\d.]+ m+, mean/)).toBeVisible();
  await expect(offer(page).getByText('Your mesh moved')).toBeHidden();
  await expect(page.getByRole('status')).toHaveText(/^Converged after \d+ iterations/);

  // The circles are drawn once the mesh is there.
  await showStep(page, 'Check');
  await expect(page.getByRole('checkbox', { name: 'Best-fitting shapes' })).toBeChecked();

  // The other button is in the panel by now; it replaces the first constraint.
  await showStep(page, 'Shape');
  await press(page, 'flat').click();
  await expect(verdict('flat')).toBeVisible();
  const flat = await waitForState(page, (now) => !now.running);
  expect(flat.constraints).toEqual({ plane: N * N });
  expect(flat.planarity?.max_distance).toBeLessThan(0.01);

  // Colours, legend and numbers are those of what was asked for last.
  await showStep(page, 'Check');
  await expect(page.getByRole('combobox', { name: 'Colour by' })).toHaveValue('planarity');
  await showStep(page, 'Shape');

  await page.getByLabel('Tolerance').fill('0.00001');
  await page.getByLabel('Tolerance').press('Enter');
  await expect(offer(page).getByText(/panels are flat within (?!1 mm)/)).toBeVisible();
  await page.getByRole('application', { name: '3D view' }).focus();
  await page.keyboard.press('Control+a');
  await waitForState(
    page,
    ({ selection }) => selection.vertices.length + selection.faces.length > 0,
  );
  // The selection first, then the card.
  await page.keyboard.press('Escape');
  await expect(offer(page)).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(offer(page)).toBeHidden();
});

test('a mesh that has the shape already has a verdict, too', async ({ page }) => {
  // The press waited for a transition to another shape, and its verdict was that of a run under way.
  await openPage(page);
  const gable = 'v 0 0 0\nv 4 0 0\nv 4 6 0\nv 0 6 0\nv 2 0 3\nv 2 6 3\nf 1 5 6 4\nf 5 2 3 6\n';
  await openText(page, 'gable.obj', gable, 6);
  await press(page, 'flat').click();
  const solved = await waitForState(page, (now) => !now.running && now.verdict !== null);
  expect(solved.verdict?.level).toBe('good');
  expect(solved.moved?.max).toBe(0);
});

// The page remembers which rows were opened.
test.describe('with every row closed', () => {
  test.use({ sameDocument: false });

  test('panels that would fold stay within a larger tolerance, and the reason is shown', async ({
    page,
  }) => {
    await openPage(page);
    await openText(page, 'bumps.obj', bumpyGrid(12), 169);
    await press(page, 'flat').click();
    const { exact } = await waitForState(page, (now) => !now.running && now.exact?.met);
    expect(exact?.eased?.folded).toBeGreaterThan(0);
    expect(exact?.tolerance).toBeGreaterThan(exact?.eased?.asked ?? NaN);
    const words =
      /^(\d+) of 144 panels are flat within 1 mm, the other (\d+) within a relaxed tolerance of [\d.]+ m+, so that none folds\./;
    await expect(offer(page).getByText(words)).toBeVisible();
    await expect(offer(page).getByText(/folded or dented/)).toBeHidden();
    await expect(offer(page).getByRole('button', { name: 'Show the folds' })).toBeHidden();
    // The row shows it, too.
    await showStep(page, 'Shape');
    const row = page.getByRole('list', { name: 'Constraints' }).getByRole('listitem');
    // It was compared with what is required of the others.
    await expect(row.getByText(/^satisfied, some within [\d.]+ m+$/)).toBeVisible();
    await row.getByRole('button', { name: /parameters/ }).click();
    await expect(row.getByText(/^\d+ panels have a relaxed tolerance of .+\.$/)).toBeVisible();
    // All of this is one undo step.
    await tool(page, 'Undo');
    await waitForState(page, (now) => Object.keys(now.constraints).length === 0);
  });
});

test('panels that fold at every tolerance are reported and shown', async ({ page }) => {
  await openPage(page);
  await openText(page, 'steps.obj', steppedGrid(8), 81);
  await press(page, 'flat').click();
  await waitForState(page, (now) => !now.running && now.exact?.met);
  await expect(offer(page).getByText(/^\d+ panels are folded or dented\. All 64 /)).toBeVisible();
  await offer(page).getByRole('button', { name: 'Show the folds' }).click();
  await waitForState(page, (now) => now.selection.faces.length > 0);
  // What would end no better is not offered.
  await expect(offer(page).getByText('Looking for suggestions …')).toBeHidden();
  await expect(offer(page).getByRole('button', { name: /Avoid|Smoother/ })).toBeHidden();
});

test('a surface that moves far is said to, and what ends better is a button with its number', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'columns.obj', columns(), 1025);
  await press(page, 'circular').click();
  await waitForState(page, (now) => !now.running && now.exact?.met);
  const moved =
    /^The surface moved by up to [\d.]+ m, \d+ % of an edge\. All 960 panels are circular/;
  await expect(offer(page).getByText(moved)).toBeVisible();
  const better = offer(page).getByRole('button', {
    name: /^Within 50 mm: the surface moves by [\d.]+ m$/,
  });
  await expect(better).toBeVisible();
  // Scripts read the same.
  const { verdict } = await state(page);
  expect(verdict).toMatchObject({ level: 'fair', within: 960, of: 960, folded: 0, eased: 0 });
  expect(verdict?.suggestions.map(({ id }) => id)).toContain('tolerance');
  await better.click();
  // It says what was chosen; the tolerance is that of the choice.
  await expect(
    offer(page).getByText(/^Within 50 mm: .*All 960 panels are circular within 50 mm\./),
  ).toBeVisible();
  await expect(page.getByLabel('Tolerance')).toHaveValue('50');
  // Another tolerance can be solved for.
  await page.getByLabel('Tolerance').fill('25');
  await page.getByLabel('Tolerance').press('Enter');
  await offer(page).getByRole('button', { name: 'Solve again within 25 mm' }).click();
  await expect(offer(page).getByText(/All 960 panels are circular within 25 mm\./)).toBeVisible();
});

for (const [device, width, height] of [
  ['a desktop', 1440, 900],
  ['a phone', 390, 844],
] as const) {
  test(`the offer covers none of the mesh on ${device}`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await openPage(page);
    // The model is as high as the view.
    await openText(
      page,
      'tower.obj',
      wavyGrid(N).replace(/^v (\S+) (\S+) .*/gm, 'v $1 0 $2'),
      VERTICES,
    );
    const card = await boxOf(offer(page));
    await expect
      .poll(() =>
        page.evaluate((count) => {
          const places = Array.from({ length: count }, (_, vertex) =>
            window.shapeUp.screen(vertex),
          );
          return Math.max(...places.map((place) => place?.[1] ?? 0));
        }, VERTICES),
      )
      .toBeLessThan(card.y);
  });
}

test('the picture moves to the result gradually, without stalling', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), VERTICES);
  const corner = await screenOf(page, 0);
  await press(page, 'circular').click();
  const places = await page.evaluate(
    () =>
      new Promise<[number, number][]>((done) => {
        const seen: [number, number][] = [];
        const began = performance.now();
        const look = () => {
          seen.push(window.shapeUp.screen(0) as [number, number]);
          if (performance.now() - began < 1500) requestAnimationFrame(look);
          else done(seen);
        };
        look();
      }),
  );
  const far = places.map(([x, y]) => Math.hypot(x - corner[0], y - corner[1]));
  const end = far[far.length - 1];
  expect(end).toBeGreaterThan(1);
  const between = far.filter((way) => way > 0.1 * end && way < 0.9 * end);
  expect(between.length).toBeGreaterThan(3);
});

test('Something else opens the constraint dialog, and the offer disappears once there is a constraint', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(N), VERTICES);
  await offer(page).getByRole('button', { name: 'Something else' }).click();
  const dialog = page.getByRole('dialog', { name: 'New constraint' });
  // The menu of the view used to close it: what is chosen there stays.
  const chosen = dialog.getByRole('radio', { name: 'Line segment', exact: true });
  await chosen.check();
  await page.getByRole('application', { name: '3D view' }).click({ button: 'right' });
  await page.getByRole('menuitem', { name: 'Add constraint' }).click();
  await expect(chosen).toBeChecked();
  await expect(chosen).toBeFocused();
  await dialog.getByRole('button', { name: /^Add/ }).first().click();
  await waitForState(page, (now) => Object.keys(now.constraints).length === 1);
  await expect(offer(page)).toBeHidden();
});

// The page remembers the last operation on a mesh.
test.describe('with no operation chosen before', () => {
  test.use({ sameDocument: false });

  test('triangles are joined to quads first, and then the press is offered', async ({ page }) => {
    await openPage(page);
    await openText(page, 'triangles.shapeup.json', triangleScene(3), 16);
    await expect(press(page, 'flat')).toBeHidden();
    const join = page.getByRole('button', { name: 'Triangles to quads', exact: true });
    await expect(join).toHaveAccessibleDescription(/triangles, which are always flat and circular/);
    await join.click();
    const dialog = page.getByRole('dialog', { name: 'Edit mesh' });
    await expect(dialog.getByText('18 faces become 9 quads, with 16 vertices.')).toBeVisible();
    await dialog.getByRole('button', { name: 'Apply' }).click();
    await waitForState(page, (now) => now.faces === 9);
    await expect(join).toBeHidden();
    await press(page, 'flat').click();
    await waitForState(page, (now) => !now.running && now.constraints.plane === 9);
  });
});

test('triangles are not offered to be joined where a lesson locks the mesh', async ({ page }) => {
  await openPage(page);
  const goals = [{ measure: 'planarity', beyond: 0.001, at_most: 3 }];
  const lesson = { text: 'Look at it.', lock: ['mesh'], goals };
  const scene = { ...JSON.parse(triangleScene(3)), lesson };
  await openText(page, 'triangles.shapeup.json', JSON.stringify(scene), 16);
  const join = page.getByRole('button', { name: 'Triangles to quads', exact: true });
  await expect(join).toBeDisabled();
  await expect(join).toHaveAttribute('title', 'Locked by the lesson');
});

test('a run that collapses the mesh says so, and can be undone or held closer', async ({
  page,
}) => {
  await openPage(page);
  const scene = JSON.parse(quadScene(N));
  delete scene.current;
  scene.constraints = [{ kind: 'circle', on: 'faces' }];
  await openText(page, 'roof.shapeup.json', JSON.stringify(scene), VERTICES);
  // Only smoothness acts on the mesh, which shrinks to a point.
  await showStep(page, 'Check');
  const weight = page.getByRole('spinbutton', { name: 'Smooth weight' });
  await weight.fill('10');
  await weight.press('Enter');
  const positions = () => page.evaluate(() => [...window.shapeUp.positions()]);
  const original = await positions();
  const alert = page.getByRole('alert');
  const run = async () => {
    await tool(page, 'Run');
    await expect(alert).toContainText(/^While iterating, the mesh shrank to a dot\./);
  };

  await run();
  const stopped = await waitForState(page, (now) => !now.running);
  expect(stopped.converged).toBe(false);
  await expect(page.getByRole('status')).not.toContainText('Converged');

  // The export requires confirmation.
  await tool(page, 'Export');
  const question = page.getByRole('dialog', { name: 'Export this shape?' });
  await question.getByRole('button', { name: 'Cancel' }).click();
  await expect(question).toBeHidden();
  const { text } = await downloaded(page, async () => {
    await tool(page, 'Export');
    await question.getByRole('button', { name: 'Export anyway' }).click();
  });
  expect(text).toContain('v ');

  await alert.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(positions).toEqual(original);

  await run();
  await alert.getByRole('button', { name: 'Hold near original positions' }).click();
  await waitForState(page, (now) => now.converged && now.iteration > 0);
  await expect(alert).toBeEmpty();

  // What was said and offered about a shape is withdrawn once it is another one.
  await tool(page, 'Undo');
  await tool(page, 'Undo');
  await run();
  await tool(page, 'Reset');
  await expect(alert).toBeEmpty();
});

test('unconstrained vertices are reported, and follow or are fixed by one click', async ({
  page,
}) => {
  await openPage(page);
  const scene = JSON.parse(quadScene(N));
  delete scene.current;
  scene.constraints = [{ kind: 'sphere', on: { vertices: [0, 1, 2, N + 1, N + 2, N + 3] } }];
  await openText(page, 'roof.shapeup.json', JSON.stringify(scene), VERTICES);
  const notice = page.getByRole('group', { name: 'Vertices that stand still' });
  await expect(notice).toContainText(`${VERTICES - 6} vertices stand still`);
  await notice.getByRole('button', { name: 'Use the weights of Keep the design' }).click();
  await expect(notice).toBeHidden();
  const positions = () => page.evaluate(() => [...window.shapeUp.positions()]);
  const before = await positions();
  await tool(page, 'Run');
  await waitForState(page, (now) => !now.running && now.iteration > 0);
  const after = await positions();
  const still = before.filter((x, i) => i % 3 === 2 && x === after[i]);
  expect(still.length).toBeLessThan(VERTICES / 2);

  await tool(page, 'Undo');
  await tool(page, 'Undo');
  await notice.getByRole('button', { name: 'Fix them' }).click();
  await expect(notice).toBeHidden();
  await waitForState(page, (now, count) => now.handles.length === count, VERTICES - 6);
});

test('vertices that stand still are those of the set that there is now', async ({ page }) => {
  // As many as before stood still, and those before stayed marked.
  await openPage(page);
  const scene = JSON.parse(quadScene(N));
  delete scene.current;
  scene.sets = { eaves: { vertices: [0, 1] } };
  scene.constraints = [{ kind: 'line', on: { set: 'eaves' } }];
  await openText(page, 'roof.shapeup.json', JSON.stringify(scene), VERTICES);
  const notice = page.getByRole('group', { name: 'Vertices that stand still' });
  await expect(notice).toContainText(`${VERTICES - 2} vertices stand still`);
  const [first, second] = [await screenOf(page, VERTICES - 1), await screenOf(page, VERTICES - 2)];
  await page.keyboard.press('1');
  await page.mouse.click(...first);
  await page.keyboard.down('Shift');
  await page.mouse.click(...second);
  await page.keyboard.up('Shift');
  await page.getByRole('button', { name: /select by/i }).click();
  const menu = page.getByRole('dialog', { name: 'Select' });
  await menu.getByRole('button', { name: 'Save as a set…' }).click();
  await page.getByRole('textbox', { name: 'Name of the set' }).fill('eaves');
  await page.getByRole('button', { name: 'Save set' }).click();
  const vertices = () => page.evaluate(() => window.shapeUp.scene().sets.eaves.vertices);
  await expect.poll(vertices).toEqual([VERTICES - 2, VERTICES - 1]);
  await settled(page);
  await notice.getByRole('button', { name: 'Select' }).click();
  const { selection } = await state(page);
  expect(selection.vertices).toContain(0);
  expect(selection.vertices).not.toContain(VERTICES - 1);
});
