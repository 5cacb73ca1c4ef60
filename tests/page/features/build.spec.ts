// From a mesh to drawings on disk: what the parts panel shows and saves.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import DxfParser, { type IDxf, type IEntity, type ILwpolylineEntity } from 'dxf-parser';
import { program } from '../../../.scripts/project.mjs';
import type { BuildReport } from '../../../www/pkg/engine/shape_up.js';
import { downloaded, openText, saved } from '../actions.ts';
import { quadScene, wavyGrid } from '../meshes.ts';
import {
  filesOf,
  openParts,
  outlinesOf,
  overPart,
  partsPanel,
  reportOf,
  setField,
} from '../sheets.ts';
import { expect, openPage, sceneOf, state, test, waitForState } from '../support.ts';

test.use({ sameDocument: true });

declare global {
  interface Window {
    /** Whether the page has asked for a print. */
    isPrinted: boolean;
  }
}

const FACES = 16;

const areaOf = (points: { x: number; y: number }[]) =>
  points.reduce((sum, { x, y }, k) => {
    const next = points[(k + 1) % points.length];
    return sum + (x * next.y - y * next.x) / 2;
  }, 0);

/** Whether a line of a drawing is closed. */
const isClosed = (line: IEntity): line is ILwpolylineEntity => (line as ILwpolylineEntity).shape;

test('another mesh leaves the focus where it is, and the settings as they are', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(4), 25);
  await openParts(page);
  await expect(partsPanel(page).getByLabel('Make')).toBeFocused();
  const groups = partsPanel(page).locator('.parts-settings details');
  await groups.first().locator('summary').click();
  await page.getByRole('application', { name: '3D view' }).focus();
  await openText(page, 'other.obj', wavyGrid(5), 36);
  await expect(partsPanel(page)).toContainText('25 panels');
  await expect(page.getByRole('application', { name: '3D view' })).toBeFocused();
  await expect(groups.first()).toHaveAttribute('open');
});

test('circular panels become drawings in mm, identical to those of the command line', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'roof.obj', `# units: m\n${wavyGrid(4)}`, 25);
  await page.getByRole('button', { name: 'Make panels circular' }).click();
  await waitForState(page, (now) => now.iteration > 0 && !now.running);
  const first = await openParts(page);
  expect(first.panels).toBe(FACES);
  await setField(page, 'Joint', 0.02);
  await waitForState(page, (now) => (now.build?.joint_mm ?? 0) > 0);
  await setField(page, 'Sheet width, mm', 200);
  await waitForState(page, (now) => now.build?.sheet_mm[0] === 200);
  await expect(partsPanel(page).getByRole('img')).toHaveCount(reportOf(await state(page)).sheets);

  const build = reportOf(await state(page));
  const archive = await downloaded(page, () =>
    partsPanel(page).getByRole('button', { name: 'Save drawings' }).click(),
  );
  expect(archive.name).toBe('roof-parts.zip');
  const files = filesOf(archive.bytes);
  const drawings = Object.keys(files).filter((name) => name.endsWith('.dxf'));
  expect(drawings).toHaveLength(build.sheets);
  const outlines = drawings.flatMap((name) => {
    const drawing = new DxfParser().parseSync(files[name].toString()) as IDxf;
    expect(drawing.header.$INSUNITS, 'mm').toBe(4);
    return drawing.entities.filter(isClosed);
  });
  expect(outlines.map(({ layer }) => layer)).toEqual(Array(FACES).fill('CUT'));
  const area = outlines.reduce((sum, { vertices }) => sum + areaOf(vertices), 0);
  expect(area / build.cut_area_mm2).toBeCloseTo(1, 6);

  // The command line writes the same bytes and numbers for this scene.
  const scene = await saved(page, 'Save scene');
  const folder = mkdtempSync(join(tmpdir(), 'shape-up-'));
  try {
    const [input, report] = ['roof.shapeup.json', 'report.json'].map((name) => join(folder, name));
    writeFileSync(input, scene.text);
    execFileSync(program, ['build', input, '--out', folder, '--report', report]);
    expect(JSON.parse(readFileSync(report, 'utf8'))).toEqual(build);
    expect(files['model.glb'].toString('latin1', 0, 4)).toBe('glTF');
    for (const [name, content] of Object.entries(files))
      expect(readFileSync(join(folder, name)).equals(content), name).toBe(true);
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('failed checks are red on the sheet at once, and a press makes the parts fit', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'roof.obj', `# units: m\n${wavyGrid(4)}`, 25);
  const before = await openParts(page);
  const missed = ({ check }: BuildReport) => check.filter(({ met }) => !met).map(({ id }) => id);
  const [flatness] = before.check.filter(({ id }) => id === 'panel_flatness');
  expect(flatness.failed).toBeGreaterThan(0);
  const failed = () => outlinesOf(partsPanel(page), 'failed');
  await expect.poll(failed).toHaveLength(flatness.failed);
  // No other line is red; cut lines are red only in the saved files.
  const lines = partsPanel(page).locator('.sheets path:not(.failed-sides)');
  const colours = await lines.evaluateAll((all) => all.map((one) => getComputedStyle(one).stroke));
  const isRed = (colour: string) => {
    const [red, green, blue] = (colour.match(/\d+/g) ?? [0, 0, 0]).map(Number);
    return red > 2 * Math.max(green, blue);
  };
  expect(colours.filter(isRed)).toEqual([]);

  // The slider is limited to safe distances.
  const slider = partsPanel(page).getByRole('slider', { name: 'Distance' });
  const safe = before.offset?.safe_distance_mm[1] ?? NaN;
  const most = Number(await slider.getAttribute('max'));
  expect(Math.abs(most) * 1000).toBeLessThan(Math.abs(safe));
  await slider.press('End');
  const far = await waitForState(page, (now) => (now.build?.offset?.distance_mm ?? NaN) > 1000);
  expect(far.build?.check.find(({ id }) => id === 'safe_distance')?.met).toBe(true);
  await page.getByRole('button', { name: 'Undo' }).click();
  await waitForState(page, (now) => (now.build?.offset?.distance_mm ?? NaN) < 1000);
  // At 0, which parts cannot have, slider and parts go back to the distance of the settings.
  const figure = partsPanel(page).getByRole('spinbutton', { name: 'Distance, in m' });
  const [kept, words] = [await slider.inputValue(), await figure.inputValue()];
  await slider.fill('0');
  await expect(slider).toHaveValue(kept);
  await expect(figure).toHaveValue(words);
  // It can be typed, and the proposed one comes back for an empty field.
  for (const [text, is] of [
    ['200 mm', '0.2'],
    ['', words],
  ]) {
    await figure.fill(text);
    await figure.press('Enter');
    await expect(figure).toHaveValue(is);
  }
  const margin = partsPanel(page).getByLabel('Margin');
  await partsPanel(page).getByText('Cutting', { exact: true }).click();
  await margin.fill('5000');
  await margin.press('Enter');
  await expect(page.getByRole('alert')).toContainText('Margin: found 5000');
  await partsPanel(page).getByText('Cutting', { exact: true }).click();

  await partsPanel(page).getByRole('button', { name: 'Meet the limits', exact: true }).click();
  const tightened = await waitForState(
    page,
    (now) => !now.running && now.build?.check.every(({ met }) => met),
  );
  expect(missed(reportOf(tightened))).toEqual([]);
  // It is a press for all panels like any other.
  await expect(page.getByRole('checkbox', { name: 'Best-fitting shapes' })).toBeChecked();
  await expect.poll(failed).toEqual([]);
  await expect(partsPanel(page).getByRole('button', { name: 'Corners' })).toContainText('exact');
  await expect(
    partsPanel(page).getByRole('button', { name: 'Meet the limits', exact: true }),
  ).toBeDisabled();
});

test('fins and a paper model are made of the same shape and saved', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', `# units: m\n${wavyGrid(4)}`, 25);
  await openParts(page);
  const made = async (product: string) => {
    await partsPanel(page).getByLabel('Make').selectOption(product);
    const build = reportOf(
      await waitForState(page, (now, own) => now.build?.product === own, product),
    );
    await expect.poll(() => outlinesOf(partsPanel(page), 'cut')).toHaveLength(build.placed);
    const archive = await downloaded(page, () =>
      partsPanel(page).getByRole('button', { name: 'Save drawings' }).click(),
    );
    return { build, files: Object.keys(filesOf(archive.bytes)) };
  };
  const fins = await made('fins');
  expect(fins.build.parts).toBe(40);
  expect(fins.files).toEqual(expect.arrayContaining(['fins.csv', 'node-types.csv', 'beams.obj']));
  const paper = await made('paper');
  expect(paper.build.paper?.tabs).toBeGreaterThan(0);
  expect(paper.files).toEqual(expect.arrayContaining(['pieces.csv', 'joins.csv', 'sheets.pdf']));
  // Clicking a piece selects its panels.
  const { at, outline } = await overPart(partsPanel(page), 0);
  await page.mouse.click(...at);
  await waitForState(page, (now) => now.selection.faces.length > 0);
  await expect.poll(() => outlinesOf(partsPanel(page), 'chosen')).toEqual([outline]);
});

test('pieces too small for their names are listed by name', async ({ page }) => {
  await openPage(page);
  const scene = JSON.parse(quadScene(6));
  // Panels of 7 mm on sheets filled with pieces.
  scene.build = { product: 'paper', scale: 143, sheet: [36, 36], gap: 0.5, margin: 1 };
  await openText(page, 'small.shapeup.json', JSON.stringify(scene), 49);
  const { unnamed, parts } = await openParts(page);
  expect(unnamed.length).toBeGreaterThan(1);
  expect(unnamed.length).toBeLessThan(parts);
  const words = `${unnamed.length} pieces have no room for a name: ${unnamed.slice(0, 6).join(', ')}`;
  await expect(partsPanel(page)).toContainText(words);
});

test('parts are exported to Rhino with layers and names', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', `# units: m\n${wavyGrid(4)}`, 25);
  await openParts(page);
  await partsPanel(page).getByLabel('Make').selectOption('fins');
  const build = reportOf(await waitForState(page, (now) => now.build?.product === 'fins'));
  const { name, bytes } = await downloaded(page, () =>
    partsPanel(page).getByRole('button', { name: 'Rhino' }).click(),
  );
  expect(name).toBe('roof-parts.3dm');
  const { default: openRhino } = await import('rhino3dm');
  const rhino = await openRhino();
  const written = rhino.File3dm.fromByteArray(new Uint8Array(bytes));
  expect(written.settings().modelUnitSystem).toBe(rhino.UnitSystem.Meters);
  const named: Record<string, string[]> = {};
  for (let i = 0; i < written.objects().count; i++) {
    const attributes = written.objects().get(i).attributes();
    (named[written.layers().get(attributes.layerIndex).name] ??= []).push(attributes.name);
  }
  expect(named.Panels).toHaveLength(FACES);
  expect(named.Nodes).toHaveLength(25);
  expect(named.Beams).toContain('B0-1');
  expect(named['Sheets CUT']).toHaveLength(build.placed);
});

test('a tolerance is chosen by the number of panel types that it leaves', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', `# units: m\n${wavyGrid(4)}`, 25);
  const { types_curve: curve, types } = await openParts(page);
  expect(types).toBe(curve.find(([at]) => at === 1)?.[1]);
  const bars = partsPanel(page).getByRole('group', { name: 'Types of panels' }).getByRole('button');
  await expect(bars).toHaveCount(curve.length);
  await bars.last().click();
  const [at, fewest] = curve[curve.length - 1];
  await waitForState(page, (now, own) => now.build?.types === own, fewest);
  await expect(bars.last()).toHaveAttribute('aria-pressed', 'true');
  expect((await sceneOf(page)).build.alike).toBe(at);
});

test('types of panels, edges and nodes are counted at each tolerance', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', `# units: m\n${wavyGrid(4)}`, 25);
  await openParts(page);
  const what = partsPanel(page).getByLabel('Types of', { exact: true });
  await expect(what.locator('option')).toHaveCount(2);
  await partsPanel(page).getByLabel('Make').selectOption('fins');
  const build = reportOf(await waitForState(page, (now) => now.build?.product === 'fins'));
  const { edge_types_curve: edges, types_curve: panels, frame } = build;
  const nodes = frame?.node_types_curve ?? [];
  for (const [noun, curve] of Object.entries({ edges, panels, nodes })) {
    await what.selectOption(noun);
    const bars = partsPanel(page)
      .getByRole('group', { name: `Types of ${noun}` })
      .getByRole('button');
    const names = await bars.evaluateAll((all) => all.map((bar) => parseInt(bar.ariaLabel ?? '')));
    expect(names).toEqual(curve.map(([, types]) => types));
  }
  // The choice stays when a tolerance is taken: a length for edges, an angle for nodes.
  const bars = partsPanel(page).getByRole('group', { name: 'Types of nodes' }).getByRole('button');
  await bars.last().click();
  await waitForState(page, (now) => now.build?.frame?.alike_deg === 2);
  await what.selectOption('edges');
  await partsPanel(page)
    .getByRole('group', { name: 'Types of edges' })
    .getByRole('button')
    .first()
    .click();
  await waitForState(page, (now) => (now.build?.edge_types ?? 0) > 1);
  await expect(what).toHaveValue('edges');
  expect((await sceneOf(page)).build).toMatchObject({ alike: edges[0][0], alike_deg: 2 });
});

test.describe('with a printer', () => {
  test.use({ sameDocument: false });

  test('the report is one page with the numbers of the card, and can be saved and printed', async ({
    page,
  }) => {
    await openPage(page);
    await openText(page, 'roof.obj', `# units: m\n${wavyGrid(4)}`, 25);
    const { check } = await openParts(page);
    const scene = await saved(page, 'Save scene');
    await partsPanel(page).getByRole('button', { name: 'Report' }).click();
    const dialog = page.getByRole('dialog', { name: 'Report' });
    const frame = dialog.getByTitle('Report on roof');
    const paper = frame.contentFrame();
    await expect(paper.getByRole('heading', { level: 1 })).toHaveText('roof');
    await expect(paper.locator('body')).toContainText('16 panels on 1 sheet');
    // The page's policy lets the style in.
    await expect(paper.locator('body')).toHaveCSS('display', 'flex');
    const states = await paper.locator('tr td:nth-child(4)').allTextContents();
    expect(states.map((words) => words === 'satisfied')).toEqual(check.map(({ met }) => met));
    // The link opens this model.
    await expect(paper.getByRole('link')).toHaveAttribute('href', /#link=/);

    const { name, text } = await downloaded(page, () =>
      dialog.getByRole('button', { name: 'Save as HTML' }).click(),
    );
    expect(name).toBe('roof-report.html');
    await expect(frame).toHaveAttribute('srcdoc', text);
    // The command line writes the same file.
    const folder = mkdtempSync(join(tmpdir(), 'shape-up-'));
    try {
      const [input, output] = ['roof.json', 'report.html'].map((file) => join(folder, file));
      writeFileSync(input, scene.text);
      const link = (await paper.getByRole('link').getAttribute('href')) ?? '';
      execFileSync(program, ['build', input, '--report-page', output, '--link', link]);
      // The command line has no view: it shows the shape from where the page does at first.
      const shape = text.replace('Current view;', 'The shape;');
      expect(readFileSync(output, 'utf8')).toBe(shape);
    } finally {
      rmSync(folder, { recursive: true });
    }

    await frame.evaluate((shown: HTMLIFrameElement) => {
      const { contentWindow } = shown as { contentWindow: Window };
      contentWindow.print = () => (window.isPrinted = true);
    });
    await dialog.getByRole('button', { name: 'Print' }).click();
    expect(await page.evaluate(() => window.isPrinted)).toBe(true);
    // Where the whole page is printed instead, only the report is on paper.
    await page.emulateMedia({ media: 'print' });
    await expect(frame).toBeVisible();
    await expect(dialog.getByRole('button')).toHaveCount(0);
    await expect(partsPanel(page)).toBeHidden();
    await page.emulateMedia({ media: null });
    // Escape closes the dialog from inside of the report too.
    await paper.getByRole('link').press('Escape');
    await expect(dialog).toBeHidden();

    const own = await page.context().newPage();
    await own.setContent(text);
    const pdf = (await own.pdf({ preferCSSPageSize: true })).toString('latin1');
    await own.close();
    const pages = [...pdf.matchAll(/\/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]/g)];
    expect(
      pages.map(([, ...size]) => size.map((points) => Math.round((Number(points) / 72) * 25.4))),
    ).toEqual([[210, 297]]);
  });
});

test('a lesson has goals on the parts, measured once the shape is at rest', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', `# units: m\n${wavyGrid(4)}`, 25);
  const scene = await sceneOf(page);
  scene.lesson = {
    text: 'Build it flat, on one sheet.',
    goals: [
      { build: 'panel_flatness', at_most: 0.001 },
      { build: 'sheets', at_most: 1 },
    ],
  };
  await openText(page, 'lesson.shapeup.json', JSON.stringify(scene), 25);
  const goals = page.getByRole('list', { name: 'Goals', exact: true });
  await expect(goals).toContainText('Sheets: at most 1');
  await expect(goals.getByRole('listitem').nth(1)).toContainText('✓');
  await expect(goals.getByRole('listitem').nth(0)).toContainText('✗');
  await page.getByRole('button', { name: 'Make panels circular' }).click();
  await waitForState(page, (now) => now.iteration > 0 && !now.running);
  await expect(goals.getByRole('listitem').nth(0)).toContainText('✓');
});
