// From circular, then exact panels to drawings on disk: the parts are the panels of the shape.

import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import DxfParser, { type IDxf, type ILwpolylineEntity } from 'dxf-parser';
import { unzipSync } from 'fflate';
import { downloaded, openText, showStep } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { settingOf } from '../sheets.ts';
import { expect, openPage, sceneOf, test, waitForState, type PageState } from '../support.ts';

test.use({ sameDocument: true });

const N = 6;
const SCALE = 50;
const roof = `# units: m\n${wavyGrid(N)}`;
/** Tolerance: a drawing has six decimals of a mm, an exact circle a billionth of the mesh size. */
const MM = 5e-6;

/** Runs `use` with a temporary folder. */
async function inFolder(use: (folder: string) => Promise<void>) {
  const folder = mkdtempSync(join(tmpdir(), 'shape-up-'));
  try {
    await use(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** Returns the outlines in the drawings of a folder, as points in mm. */
function outlinesIn(folder: string): number[][][] {
  const drawings = readdirSync(folder).filter((name) => name.endsWith('.dxf'));
  return drawings.flatMap((name) => {
    const { header, entities } = new DxfParser().parseSync(
      readFileSync(join(folder, name), 'ascii'),
    ) as IDxf;
    expect(header.$INSUNITS, 'mm').toBe(4);
    const cut = entities.filter(({ layer }) => layer === 'CUT') as ILwpolylineEntity[];
    expect(
      cut.every(({ shape }) => shape),
      'outlines are closed',
    ).toBe(true);
    return cut.map(({ vertices }) => vertices.map(({ x, y }) => [x, y]));
  });
}

const distance = (p: number[], q: number[]) => Math.hypot(...p.map((x, axis) => x - q[axis]));

/** Returns the area of a flat polygon in the plane or in space. */
function areaOf(corners: number[][]) {
  const [o, ...rest] = corners.map(([x, y, z = 0]) => [x, y, z]);
  const sum = [0, 0, 0];
  for (let k = 0; k + 1 < rest.length; k++) {
    const [[a, b, c], [d, e, f]] = [rest[k], rest[k + 1]].map((p) => p.map((x, i) => x - o[i]));
    [b * f - c * e, c * d - a * f, a * e - b * d].forEach((x, axis) => (sum[axis] += x / 2));
  }
  return Math.hypot(...sum);
}

/** The distances between all pairs of corners, in order; congruent polygons have the same ones. */
const spans = (corners: number[][]) =>
  corners.flatMap((p, k) => corners.slice(k + 1).map((q) => distance(p, q)));
const turned = (corners: number[][], by: number) => [...corners.slice(by), ...corners.slice(0, by)];

/** Expects each panel once in the drawings, with its edges and area. */
function expectPanels(
  outlines: number[][][],
  positions: number[][],
  faces: number[][],
  toSheet: number,
) {
  expect(outlines).toHaveLength(faces.length);
  const left = [...outlines];
  for (const face of faces) {
    const corners = face.map((v) => positions[v].map((x) => x * toSheet));
    const own = spans(corners);
    const differs = (outline: number[][]) =>
      Math.min(
        ...outline.map((_, by) =>
          Math.max(...spans(turned(outline, by)).map((span, k) => Math.abs(span - own[k]))),
        ),
      );
    const errors = left.map(differs);
    const nearest = errors.indexOf(Math.min(...errors));
    expect(errors[nearest], `panel ${face}`).toBeLessThan(MM);
    const [outline] = left.splice(nearest, 1);
    expect(areaOf(outline) / areaOf(corners)).toBeCloseTo(1, 6);
    // Ptolemy's theorem: the four corners lie on a circle.
    const [a, b, c, d, e, f] = spans(outline);
    expect(Math.abs(b * e - a * f - c * d) / (b * e)).toBeLessThan(1e-6);
  }
}

const isExact = ({ running, exact }: PageState) =>
  !running && exact?.met && exact.max_distance < 1e-9;

test('panels made circular and then exact are the outlines in the saved drawings', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'roof.obj', roof, (N + 1) ** 2);
  await page.getByRole('button', { name: 'Make panels circular', exact: true }).click();
  await waitForState(page, (now) => !now.running && now.exact?.met);
  const verdict = page.getByRole('group', { name: 'Verdict' });
  await verdict.getByRole('button', { name: 'Make exact' }).click();
  await waitForState(page, isExact);

  await showStep(page, 'Shape');
  await page.getByRole('button', { name: 'Build', exact: true }).click();
  await waitForState(page, (now) => now.build !== null);
  const parts = page.getByRole('region', { name: 'Build: parts and sheets' });
  const width = await settingOf(page, 'Sheet width, mm');
  await width.fill('60');
  await width.press('Tab');
  const { build } = await waitForState(page, (now) => now.build?.sheet_mm[0] === 60);
  expect(build?.scale).toBe(SCALE);
  expect(build?.sheets, 'the story has several drawings').toBeGreaterThan(1);
  const { bytes } = await downloaded(page, () =>
    parts.getByRole('button', { name: 'Save drawings' }).click(),
  );
  await inFolder(async (folder) => {
    for (const [name, content] of Object.entries(unzipSync(bytes)))
      writeFileSync(join(folder, name), content);
    const { faces } = (await sceneOf(page)).mesh;
    const flat = await page.evaluate(() => [...window.shapeUp.positions()]);
    const positions = Array.from({ length: flat.length / 3 }, (_, v) =>
      flat.slice(3 * v, 3 * v + 3),
    );
    expectPanels(outlinesIn(folder), positions, faces, 1000 / SCALE);
  });
});
