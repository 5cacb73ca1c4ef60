// Exports, and that they equal those of the command line for the same scene.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { PolylineCurve } from 'rhino3dm';
import { program } from '../../../.scripts/project.mjs';
import { addConstraint, exported, openText, saved, tool } from '../actions.ts';
import { file, tetScene, wavyGrid } from '../meshes.ts';
import { decodePng, differingBytes, distinctColours, type Picture } from '../picture.ts';
import {
  boxOf,
  expect,
  looks,
  middleOfPicture,
  openPage,
  positionOf,
  seen,
  state,
  test,
  waitForState,
} from '../support.ts';

test.use({ sameDocument: true });

const STEPS = 5;

const BOX = [
  ...[0, 1].flatMap((z) => [0, 2].flatMap((y) => [0, 3].map((x) => `v ${x} ${y} ${z}`))),
  ...['1 3 4 2', '5 6 8 7', '1 2 6 5', '3 7 8 4', '1 5 7 3', '2 4 8 6'].map((f) => `f ${f}`),
].join('\n');

/** The rows of a table as objects, keyed by the column headings without units. */
function rowsOf(csv: string): Record<string, number>[] {
  const [head, ...rows] = csv.trim().split('\n');
  const names = head.split(',').map((name) => name.replace(/ \(.*/, ''));
  return rows.map((row) =>
    Object.fromEntries(row.split(',').map((value, i) => [names[i], Number(value)])),
  );
}

/** A hexagon beside two quads, in groups, with a curve. */
const PANELS = `# units: mm
v 0 0 0\nv 1000 0 10\nv 2000 0 0\nv 0 1000 0\nv 1000 1000.123456789012 0\nv 2000 1000 30
v 3000 -500 0\nv 4000 0 20\nv 4000 1000 0\nv 3000 1500 0
g west\nf 1 2 5 4\ng middle\nf 2 3 6 5\ng east\nf 3 7 8 9 10 6\nl 1 2 3\n`;

test('mesh and tables equal those of the command line for the same scene', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await addConstraint(page, 'Circle', 'each face');
  const scene = await saved(page, 'Save scene');
  for (let i = 1; i <= STEPS; i++) {
    await page.getByRole('button', { name: 'Step' }).click();
    await waitForState(page, (now, count) => now.iteration === count, i);
  }
  const mesh = await exported(page, 'OBJ');
  expect(mesh.name).toBe('roof.obj');
  const errors = await exported(page, 'Errors');
  expect(errors.name).toBe('roof-errors.csv');
  const convergence = await exported(page, 'Convergence');
  expect(convergence.name).toBe('roof-convergence.csv');

  const folder = mkdtempSync(join(tmpdir(), 'shape-up-'));
  try {
    const [input, solved, output] = ['roof.shapeup.json', 'roof.obj', 'report.json'].map((name) =>
      join(folder, name),
    );
    writeFileSync(input, scene.text);
    const options = ['--iterations', String(STEPS), '--trace', '--out', solved, '--report', output];
    execFileSync(program, ['solve', input, ...options]);
    expect(mesh.text).toBe(readFileSync(solved, 'utf8'));
    const report = JSON.parse(readFileSync(output, 'utf8'));
    expect(rowsOf(convergence.text)).toEqual(report.trace);
    const rows = rowsOf(errors.text);
    expect(rows).toHaveLength(report.faces);
    const most = (name: string) => Math.max(...rows.map((row) => row[name]));
    expect(most('Planarity')).toBe(report.planarity.max_distance);
    expect(most('Circularity')).toBe(report.circularity.max_distance);
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('formats are grouped by purpose, and cut sheets lead to Build', async ({ page }) => {
  await openPage(page);
  await tool(page, 'More formats');
  const dialog = page.getByRole('dialog', { name: 'More formats' });
  await expect(dialog.getByRole('heading', { level: 3 })).toHaveText([
    'Back to Rhino',
    'Other programs',
    'Cut sheets',
    'Numbers',
    'Pictures',
  ]);
  await dialog.getByRole('button', { name: /^Build/ }).click();
  await expect(dialog).toBeHidden();
  await expect(page.getByRole('heading', { name: 'Build: parts and sheets' })).toBeVisible();
});

test('the exported scene equals that of Save scene', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(3), 16);
  expect((await exported(page, 'Scene')).text).toBe((await saved(page, 'Save scene')).text);
});

test('a picture has the chosen size, legend and background', looks, async ({ page }) => {
  // The largest picture has 16 times the pixels of the view.
  await page.setViewportSize({ width: 720, height: 420 });
  await openPage(page);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
  const view = await boxOf(page.getByRole('application', { name: '3D view' }));
  const shown = await middleOfPicture(page);
  const pictures: Record<string, Picture> = {};
  for (const [scale, legend, ground] of [
    [1, true, 'white'],
    [1, false, 'white'],
    [1, false, 'none'],
    [2, false, 'view'],
    [4, true, 'white'],
  ] as const) {
    await tool(page, 'More formats');
    const dialog = page.getByRole('dialog', { name: 'More formats' });
    await dialog.getByRole('radio', { name: `${scale}×` }).check();
    await dialog.getByLabel('Legend').setChecked(legend);
    await dialog.getByRole('combobox', { name: 'Background' }).selectOption(ground);
    await page.keyboard.press('Escape');
    const save = () => exported(page, 'PNG');
    // Filling and decoding the largest picture is slow, and its pixels are covered by the others.
    const { bytes, name } = await (scale > 2 ? save() : seen(page, save));
    expect(name).toMatch(/\.png$/);
    // The PNG header has the size.
    expect([bytes.readUInt32BE(16), bytes.readUInt32BE(20)]).toEqual(
      [view.width, view.height].map((side) => Math.round(side * scale)),
    );
    if (scale > 2) continue;
    const picture = decodePng(bytes);
    expect(distinctColours(picture)).toBeGreaterThan(50);
    pictures[`${scale} ${legend} ${ground}`] = picture;
  }
  const corner = (picture: Picture) => [...picture.pixels.slice(0, 3)];
  expect(corner(pictures['1 true white'])).toEqual([255, 255, 255]);
  expect(corner(pictures['2 false view'])).not.toEqual([255, 255, 255]);
  // The legend is in the lower left corner, which is empty without it.
  const inCorner = ({ pixels, width, height, channels }: Picture) => {
    const found = new Set();
    for (let y = height - 44; y < height; y++) {
      for (let x = 16; x < 200; x++) {
        const at = (y * width + x) * channels;
        found.add(pixels.subarray(at, at + 3).join());
      }
    }
    return found.size;
  };
  expect(inCorner(pictures['1 true white'])).toBeGreaterThan(20);
  expect(inCorner(pictures['1 false white'])).toBeLessThan(inCorner(pictures['1 true white']) / 2);
  // The transparent picture composed over white equals the picture on white.
  const [cut, white] = ['none', 'white'].map((ground) => pictures[`1 false ${ground}`]);
  expect(cut.channels).toBe(4);
  expect(cut.pixels[3], 'nothing in the corner').toBe(0);
  let worst = 0;
  for (let pixel = 0; pixel < cut.width * cut.height; pixel++) {
    const covered = cut.pixels[4 * pixel + 3] / 255;
    for (let i = 0; i < 3; i++) {
      const laid = covered * cut.pixels[4 * pixel + i] + 255 * (1 - covered);
      worst = Math.max(worst, Math.abs(laid - white.pixels[white.channels * pixel + i]));
    }
  }
  expect(worst).toBeLessThan(6);
  // The view itself is unchanged.
  expect(differingBytes(await middleOfPicture(page), shown)).toBe(0);
});

test('a picture on white leaves the view in the dark theme', looks, async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'dark' });
  await openPage(page);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
  const before = await middleOfPicture(page);
  await tool(page, 'More formats');
  const dialog = page.getByRole('dialog', { name: 'More formats' });
  await dialog.getByRole('combobox', { name: 'Background' }).selectOption('white');
  await page.keyboard.press('Escape');
  await exported(page, 'PNG');
  // Turned a little, so that it is drawn anew, and back.
  for (const key of ['ArrowLeft', 'ArrowRight']) await page.keyboard.press(key);
  const changed = differingBytes(await middleOfPicture(page), before);
  expect(changed).toBeLessThan(0.1 * before.pixels.length);
});

test('a line drawing for print has the visible lines, in millimetres', async ({ page }) => {
  await openPage(page);
  await openText(page, 'box.obj', BOX, 8);
  const { name, text } = await exported(page, 'Line drawing');
  expect(name).toBe('box-drawing.svg');
  const lines = await page.evaluate((svg) => {
    const drawing = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
    const count = (id: string) => {
      const path = drawing.querySelector(`#${id} path`);
      // A path without lines would be a mistake.
      return path ? (path.getAttribute('d')?.match(/M/g)?.length ?? NaN) : 0;
    };
    const [outlines, edges, circles] = ['outlines', 'edges', 'circles'].map(count);
    const [width, height] = ['width', 'height'].map((side) => drawing.getAttribute(side) ?? '');
    return { outlines, edges, circles, width, height };
  }, text);
  // Three of the twelve edges are hidden.
  expect([lines.outlines, lines.edges, lines.circles]).toEqual([6, 3, 0]);
  const side = /^[\d.]+mm$/;
  expect(lines.width).toMatch(side);
  expect(lines.height).toMatch(side);
  expect([parseFloat(lines.width) <= 277, parseFloat(lines.height) <= 190]).toEqual([true, true]);
  expect(await page.evaluate(() => window.shapeUp.lineDrawing())).toBe(text);
});

test('a Rhino file is exported and opened again', async ({ page }) => {
  await openPage(page);
  await openText(page, 'panels.obj', PANELS, 10);
  const { name, bytes } = await exported(page, '3DM');
  expect(name).toBe('panels.3dm');

  const { default: openRhino } = await import('rhino3dm');
  const rhino = await openRhino();
  const written = rhino.File3dm.fromByteArray(new Uint8Array(bytes));
  expect(written.settings().modelUnitSystem).toBe(rhino.UnitSystem.Millimeters);
  const objects = Array.from({ length: written.objects().count }, (_, i) => {
    const object = written.objects().get(i);
    const attributes = object.attributes();
    return {
      kind: object.geometry().constructor.name,
      layer: written.layers().get(attributes.layerIndex).name,
      planarity: attributes.getUserString('shape-up:planarity'),
      points: (object.geometry() as PolylineCurve).pointCount,
    };
  });
  expect(objects.map(({ kind, layer }) => `${kind} on ${layer}`)).toEqual([
    'Mesh on west',
    'Mesh on middle',
    'PolylineCurve on east',
    'PolylineCurve on Curves',
  ]);
  expect(objects[2].points).toBe(7);
  const { planarity } = await state(page);
  const distances = objects.slice(0, 3).map((object) => Number.parseFloat(object.planarity));
  expect(Math.max(...distances)).toBe(planarity?.max_distance);
  expect(objects[2].planarity).toMatch(/ mm$/);

  const corners = await Promise.all([...Array(10).keys()].map((v) => positionOf(page, v)));
  await openText(page, 'other.obj', wavyGrid(2), 9);
  await page
    .getByLabel('Open file')
    .setInputFiles({ name, mimeType: 'application/octet-stream', buffer: bytes });
  const after = await waitForState(page, (now) => now.vertices === 10);
  expect(after.faces).toBe(3);
  const scene = await page.evaluate(() => window.shapeUp.scene());
  expect(scene.units).toBe('mm');
  expect(Object.keys(scene.mesh.groups)).toEqual(['west', 'middle', 'east']);
  expect(scene.mesh.faces.map((face: number[]) => face.length)).toEqual([4, 4, 6]);
  expect(scene.mesh.curves).toHaveLength(1);
  const sorted = (points: number[][]) => points.map((point) => point.join()).sort();
  expect(sorted(scene.mesh.positions)).toEqual(sorted(corners));
});

test('faces that are left as they are go to Rhino and back, and tetrahedra are refused', async ({
  page,
}) => {
  // They were missing there, without a word.
  await openPage(page);
  const vertices = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1.5 0\nv -0.5 0.5 0\n';
  const touching = `${vertices}g Roof::North\nf 1 2 3\nf 1 2 3 1 4 5\n`;
  await openText(page, 'roof.obj', touching, 5);
  const { name, bytes } = await exported(page, '3DM');
  const { default: openRhino } = await import('rhino3dm');
  const { File3dm, UnitSystem } = await openRhino();
  const written = File3dm.fromByteArray(new Uint8Array(bytes));
  // For a model so small no unit is guessed: its scene has none, and it was not exported at all.
  expect(written.settings().modelUnitSystem).toBe(UnitSystem.None);
  const layers = written.layers();
  // Layers in layers, as Rhino files have them.
  const names = Array.from({ length: layers.count }, (_, i) => layers.get(i).name);
  expect(names).toEqual(['Roof', 'North', 'Panels']);
  await openText(page, 'cube.shapeup.json', tetScene(), 8);
  await tool(page, 'More formats');
  const dialog = page.getByRole('dialog', { name: 'More formats' });
  await dialog.getByRole('button', { name: /^3DM/ }).click();
  await expect(dialog).toContainText('There are no faces or curves');
  await page.keyboard.press('Escape');
  await page
    .getByLabel('Open file')
    .setInputFiles({ name, mimeType: 'application/octet-stream', buffer: bytes });
  await waitForState(page, (now) => now.vertices === 5);
  const { mesh } = await page.evaluate(() => window.shapeUp.scene());
  expect(mesh.faces).toHaveLength(1);
  expect(Object.keys(mesh.groups)).toEqual(['Roof::North']);
  expect(mesh.untouched.map((face: number[]) => face.length)).toEqual([6]);
});

test('a Rhino file without readable geometry is refused with the reason', async ({ page }) => {
  await openPage(page);
  const { default: openRhino } = await import('rhino3dm');
  const rhino = await openRhino();
  const input = page.getByLabel('Open file');
  await input.setInputFiles(file('broken.3dm', 'not a file of Rhino'));
  await expect(page.getByRole('alert')).toContainText('broken.3dm');
  const written = new rhino.File3dm();
  written.objects().addPoint([0, 0, 0]);
  const buffer = Buffer.from(written.toByteArray());
  const given = { name: 'points.3dm', mimeType: 'application/octet-stream', buffer };
  await input.setInputFiles(given);
  await expect(page.getByRole('alert')).toContainText('no mesh or polyline');
});

test('a script gets the same picture in one tile or in several', looks, async ({ page }) => {
  await openPage(page);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
  const compared = async () => {
    const small = async (width: number) => {
      const blob = await window.shapeUp.picture({ width, legend: false, ground: 'white' });
      const image = await createImageBitmap(blob);
      const [w, h] = [300, Math.round((300 * image.height) / image.width)];
      const canvas = new OffscreenCanvas(w, h);
      const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D;
      context.imageSmoothingQuality = 'high';
      context.drawImage(image, 0, 0, w, h);
      return { width: image.width, data: context.getImageData(0, 0, w, h).data };
    };
    // One tile, and two tiles side by side.
    const [one, two] = [await small(1500), await small(3000)];
    let sum = 0;
    let plain = 0;
    one.data.forEach((byte, i) => {
      sum += Math.abs(byte - two.data[i]);
      plain += byte < 200 ? 1 : 0;
    });
    return { widths: [one.width, two.width], mean: sum / one.data.length, plain };
  };
  const found = await seen(page, () => page.evaluate(compared));
  expect(found.widths).toEqual([1500, 3000]);
  expect(found.plain, 'there is a picture').toBeGreaterThan(5000);
  expect(found.mean).toBeLessThan(4);
});

test('a film shows one turn if the browser can record', looks, async ({ page }) => {
  await openPage(page);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
  const corner = () => page.evaluate(() => window.shapeUp.screen(0) as [number, number]);
  const before = await corner();
  const record = async () => {
    const blob = await window.shapeUp.turntable(1);
    const head = new Uint8Array(await blob.slice(0, 4).arrayBuffer());
    return { type: blob.type, size: blob.size, head: [...head] };
  };
  const film = await seen(page, () => page.evaluate(record));
  // The signature of a Matroska file.
  expect(film.head).toEqual([0x1a, 0x45, 0xdf, 0xa3]);
  expect(film.type).toBe('video/webm');
  expect(film.size).toBeGreaterThan(2000);
  const after = await corner();
  after.forEach((at, i) => expect(at).toBeCloseTo(before[i], 0));
  await tool(page, 'More formats');
  await expect(page.getByRole('button', { name: /^WebM/ })).toBeVisible();
});

test('a film ends with its model, and leaves the camera of the next one', async ({ page }) => {
  // Both models were in the film, saved under the name of the second, which was shown as the first.
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
  const names: string[] = [];
  page.on('download', (download) => names.push(download.suggestedFilename()));
  await tool(page, 'More formats');
  const dialog = page.getByRole('dialog', { name: 'More formats' });
  await dialog.getByRole('button', { name: /^WebM/ }).click();
  await expect(dialog.getByText('Working …')).toBeVisible();
  await page.keyboard.press('Escape');
  const camera = async () => {
    await openText(page, 'wide.obj', wavyGrid(9), 100);
    await page.evaluate(() => window.shapeUp.drawn());
    return page.evaluate(() => window.shapeUp.camera());
  };
  const during = await camera();
  await expect(page.getByRole('alert')).toContainText('roof.webm was not saved');
  expect(await page.evaluate(() => window.shapeUp.camera())).toEqual(during);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  expect(await camera()).toEqual(during);
  expect(names).toEqual([]);
});

test('what goes wrong after the dialog was closed is told in the page', async ({ page }) => {
  // It was told in the dialog that was gone.
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  let answer = () => {};
  const closed = new Promise<void>((resolve) => (answer = resolve));
  const part = '**/rhino-worker-*.js';
  await page.route(part, (route) => closed.then(() => route.abort()));
  await tool(page, 'More formats');
  const dialog = page.getByRole('dialog', { name: 'More formats' });
  await dialog.getByRole('button', { name: /^3DM/ }).click();
  await expect(dialog.getByText('Working …')).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(dialog).toBeHidden();
  answer();
  await expect(page.getByRole('alert')).toContainText('.3dm converter could not be loaded');
  await page.unroute(part);
});
