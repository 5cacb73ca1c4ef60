// Files as they come: open seams, PLY and STL, what a Rhino file hides, and the table in the help.

import { exported, openText, showStep } from '../actions.ts';
import { file } from '../meshes.ts';
import { expect, openPage, state, test, waitForState } from '../support.ts';

test.use({ sameDocument: true });

/** Two patches of four quads side by side, each with three vertices of its own along the seam. */
const PATCHES = [0, 2]
  .flatMap((left, patch) => {
    const places = [0, 1, 2].flatMap((y) => [0, 1, 2].map((x) => [left + x, y]));
    const vertices = places.map(([x, y]) => `v ${x} ${y} ${(x * y) / 10}`);
    const corners = [1, 2, 4, 5].map((first) => first + 9 * patch);
    return [...vertices, ...corners.map((v) => `f ${v} ${v + 1} ${v + 4} ${v + 3}`)];
  })
  .join('\n');

test('an open seam is named, and joined by one press that can be undone', async ({ page }) => {
  await openPage(page);
  await openText(page, 'patches.obj', PATCHES, 18);
  await showStep(page, 'Shape');
  const panel = page.getByRole('listitem').filter({ hasText: '3 boundary vertices that lie on' });
  await expect(panel).toContainText('line 14');
  await panel.getByRole('button', { name: 'Join them' }).click();
  await waitForState(page, (now) => now.vertices === 15);
  expect((await state(page)).problems).toHaveLength(0);
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await waitForState(page, (now) => now.vertices === 18);
});

test('PLY and STL are opened as they are exported', async ({ page }) => {
  await openPage(page);
  await openText(page, 'patches.obj', PATCHES, 18);
  for (const [format, ending, vertices, faces] of [
    ['PLY', 'ply', 18, 8],
    ['STL', 'stl', 15, 16],
  ] as const) {
    const { name, bytes } = await exported(page, format);
    expect(name).toBe(`patches.${ending}`);
    const given = { name, mimeType: 'application/octet-stream', buffer: bytes };
    await page.getByLabel('Open file').setInputFiles(given);
    await waitForState(page, (now) => now.problems.length < 9);
    await expect(page.getByRole('status')).toContainText(
      `Opened patches.${ending}: ${vertices} vertices, ${faces} faces`,
    );
    await openText(page, 'patches.obj', PATCHES, 18);
  }
});

/** A Rhino file of squares side by side, shown or not, and a sphere. */
async function rhinoFile(name: string, ...shown: boolean[]) {
  const { default: openRhino } = await import('rhino3dm');
  const rhino = await openRhino();
  const made = new rhino.File3dm();
  shown.forEach((visible, i) => {
    const mesh = new rhino.Mesh();
    for (const [a, b] of [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ])
      mesh.vertices().addPoint3d(5 * i + a, b, a * b);
    mesh.faces().addQuadFace(0, 1, 2, 3);
    const attributes = new rhino.ObjectAttributes();
    attributes.visible = visible;
    made.objects().addMesh(mesh, attributes);
  });
  made.objects().addSphere(new rhino.Sphere([0, 0, 0], 1), new rhino.ObjectAttributes());
  const buffer = Buffer.from(made.toByteArray());
  return { name, mimeType: 'application/octet-stream', buffer };
}

test('hidden objects of a Rhino file are left out, counted, and loaded if asked for', async ({
  page,
}) => {
  await openPage(page);
  await page.getByLabel('Open file').setInputFiles(await rhinoFile('hidden.3dm', true, false));
  await waitForState(page, (now) => now.vertices === 4);
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('1 surface or solid was left out: convert with Rhino’s Mesh');
  await expect(alert).toContainText(
    '1 object is hidden or on a layer that is off, and not loaded.',
  );
  await alert.getByRole('button', { name: 'Load it too' }).click();
  await waitForState(page, (now) => now.vertices === 8);
  await expect(alert).not.toContainText('hidden');
});

test('all that an opening leaves out is said, of the Rhino file and of the other files', async ({
  page,
}) => {
  // The last message replaced the others in the same moment.
  await openPage(page);
  const given = [await rhinoFile('roof.3dm', true), file('photo.jpg', '')];
  await page.getByLabel('Open file').setInputFiles(given);
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('Opened roof.3dm. Left out: photo.jpg');
  await expect(alert).toContainText('1 surface or solid was left out');
  await openText(page, 'patches.obj', PATCHES, 18);
  await expect(alert).not.toContainText('left out');
});

test('the help has the table of formats, and the file chooser offers what is read', async ({
  page,
}) => {
  await openPage(page);
  await page.keyboard.press('?');
  const help = page.getByRole('dialog', { name: 'Mouse and keys' });
  const rows = help.getByRole('table', { name: 'Files' }).getByRole('row');
  await expect(help.getByRole('row', { name: /^PLY/ })).toContainText('text and binary');
  const read = await rows.evaluateAll((all) =>
    all.flatMap((row) => {
      const [, reads] = [...row.children].map((cell) => cell.textContent);
      const endings = row.querySelector('span')?.textContent ?? '';
      return row.querySelector('td') && reads !== '–' ? endings.split(' ') : [];
    }),
  );
  const accepted = (await page.getByLabel('Open file').getAttribute('accept')) ?? '';
  expect(accepted.split(',').sort()).toEqual(read.sort());
  await page.keyboard.press('Escape');
});
