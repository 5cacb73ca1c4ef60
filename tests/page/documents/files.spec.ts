// Opening and saving files.

import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { addConstraint, exported, openText, runToTheEnd, saved, showStep } from '../actions.ts';
import { file, wavyGrid } from '../meshes.ts';
import {
  boxOf,
  coloursOfView,
  expect,
  known,
  looks,
  openPage,
  screenOf,
  settled,
  state,
  test,
  waitForState,
} from '../support.ts';

test.use({ sameDocument: true });

test('a mesh opens with a report of its errors', async ({ page }) => {
  await openPage(page);
  await openText(page, 'odd.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n', 3);
  await showStep(page, 'Shape');
  await expect(page.getByText(/line 4: `f 1 2 x`/)).toBeVisible();
  await openText(page, 'roof.obj', `${wavyGrid(4)}f 1 2\n`, 25);
  const { faces, problems } = await state(page);
  expect(faces).toBe(16);
  expect(problems).toHaveLength(1);
  await expect(page.getByRole('status')).toHaveText(/roof\.obj: 25 vertices, 16 faces/);
  await showStep(page, 'Shape');
  await expect(page.getByText('1 kind of problem in the file')).toBeVisible();
});

test('problems open the step that lists them, and are said there only', async ({ page }) => {
  await openPage(page);
  await page.locator('#step-open > summary').click();
  await expect(page.locator('#step-open')).not.toHaveAttribute('open');
  const fins = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n';
  await openText(page, 'fins.obj', fins, 5);
  await expect(page.getByText(/problems? in the file/)).toBeVisible();
  await settled(page);
  await expect(page.getByRole('alert')).not.toContainText('see Open or make');
});

test('a mesh without faces opens too', looks, async ({ page }) => {
  await openPage(page);
  await waitForState(page, (now) => now.renderer.startsWith('web'));
  const corners = 'v 0 0 0\nv 2 0 0\nv 2 1 1\nv 0 1 0\n';
  for (const [name, elements] of [
    ['points.obj', ''],
    ['curve.obj', 'l 1 2 3 4 1\n'],
  ]) {
    await openText(page, name, corners + elements, 4);
    await waitForState(page, (now) => now.faces === 0);
    await expect(page.getByRole('status')).toHaveText(`Opened ${name}: 4 vertices, 0 faces`);
    expect(await screenOf(page, 2)).toHaveLength(2);
    await expect.poll(() => coloursOfView(page)).toBeGreaterThan(5);
  }
});

test('a broken file is refused with the reason, and the old mesh stays', async ({ page }) => {
  await openPage(page);
  const before = await state(page);
  await page.getByLabel('Open file').setInputFiles(file('broken.obj', 'this is not a mesh\n'));
  await expect(page.getByRole('alert')).toContainText('broken.obj');
  await expect(page.getByRole('alert')).toContainText('no vertices');
  const after = await state(page);
  expect([after.vertices, after.faces]).toEqual([before.vertices, before.faces]);

  // The same holds for a file that is no mesh.
  await page.getByLabel('Open file').setInputFiles(file('house.ifc', 'ISO-10303-21;'));
  await expect(page.getByRole('alert')).toContainText('house.ifc');
  expect((await state(page)).vertices).toBe(before.vertices);
});

test('a file dropped on the window opens, and a scene with its mesh beside it', async ({
  page,
}) => {
  await openPage(page);
  const data = await page.evaluateHandle((text) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([text], 'dropped.obj'));
    return transfer;
  }, wavyGrid(3));
  await page.dispatchEvent('footer', 'dragover', { dataTransfer: data });
  await expect(page.getByText('Drop to open')).toBeVisible();
  await page.dispatchEvent('footer', 'drop', { dataTransfer: data });
  await waitForState(page, (now) => now.vertices === 16);
  await expect(page.getByText('Drop to open')).toBeHidden();

  // The scene needs its mesh file.
  const scene = JSON.stringify({
    format: 'shape-up-scene',
    version: 1,
    mesh: { file: 'grid.obj' },
    constraints: [{ kind: 'circle', on: 'faces' }],
  });
  const input = page.getByLabel('Open file');
  await input.setInputFiles(file('grid.shapeup.json', scene));
  await expect(page.getByRole('alert')).toContainText('grid.obj');
  const both = await page.evaluateHandle(
    (files) => {
      const transfer = new DataTransfer();
      for (const [name, text] of files) transfer.items.add(new File([text], name));
      return transfer;
    },
    [
      ['grid.shapeup.json', scene],
      ['grid.obj', wavyGrid(3)],
    ],
  );
  // At the bottom, too, where a single file is a surface: the mesh was one, and the scene was dropped.
  const clientY = await page.evaluate(() => window.innerHeight - 10);
  await page.dispatchEvent('footer', 'drop', { dataTransfer: both, clientY });
  await waitForState(page, (now) => now.vertices === 16 && now.constraints.circle === 9);
  await expect(page.getByRole('alert')).toBeEmpty();
});

test('the model is fitted to a second file, dropped at the bottom of the window or chosen in the settings', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, 'grid.obj', wavyGrid(3), 16);
  const raised = 'v -50 -50 9\nv 50 -50 9\nv 50 50 9\nv -50 50 9\nf 1 2 3 4\n';
  const closeness = async () =>
    await page.evaluate(() => window.shapeUp.scene().closeness?.to?.mesh?.positions?.length);
  const data = await page.evaluateHandle((text) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([text], 'raised.obj'));
    return transfer;
  }, raised);
  await page.dispatchEvent('footer', 'dragover', { dataTransfer: data });
  const fit = page.getByText('Fit to this');
  await expect(fit).toBeVisible();
  const { y, height } = await boxOf(fit);
  await page.dispatchEvent('footer', 'drop', { dataTransfer: data, clientY: y + height / 2 });
  await expect.poll(closeness).toBe(4);
  await expect(fit).toBeHidden();
  expect((await state(page)).vertices).toBe(16);
  await page.keyboard.press('Control+z');
  await expect.poll(closeness).toBeUndefined();

  await showStep(page, 'Check');
  await page.getByText('More settings').click();
  const input = page.getByLabel('Fit to another surface');
  await input.setInputFiles(file('broken.obj', 'v 0 0 0\n'));
  await expect(page.getByRole('alert')).toContainText('neither faces nor curves');
  await input.setInputFiles(file('raised.obj', raised));
  await expect.poll(closeness).toBe(4);
  await expect(page.getByText('lie on the other surface')).toBeVisible();
});

test('of several dropped files one model is opened, and the files left out are named', async ({
  page,
}) => {
  const folder = mkdtempSync(join(tmpdir(), 'shape-up-'));
  try {
    const [roof, tower, finish, sheets] = ['roof.obj', 'tower.obj', 'roof.mtl', 'sheets'].map(
      (name) => join(folder, name),
    );
    writeFileSync(roof, wavyGrid(3));
    writeFileSync(tower, wavyGrid(5));
    writeFileSync(finish, 'newmtl finish');
    mkdirSync(sheets);
    await openPage(page);
    const session = await page.context().newCDPSession(page);
    const drop = async (files: string[]) => {
      const at = { x: 700, y: 450, data: { items: [], files, dragOperationsMask: 1 } };
      for (const type of ['dragEnter', 'dragOver', 'drop'] as const)
        await session.send('Input.dispatchDragEvent', { type, ...at });
    };
    const message = page.getByRole('alert').getByRole('paragraph');

    await drop([sheets]);
    await expect(message).toHaveText('sheets is a folder. Open the files in it instead.');
    await drop([roof, tower, finish, sheets]);
    await waitForState(page, (now) => now.vertices === 16);
    await expect(message).toHaveText(
      'Opened roof.obj. Left out: tower.obj (one model at a time), roof.mtl (neither a mesh nor a scene), sheets (a folder: open the files in it).',
    );
    await drop([tower]);
    await waitForState(page, (now) => now.vertices === 36);
    await expect(message).toBeHidden();
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('a saved scene opens as it was', async ({ page }) => {
  await openPage(page);
  await openText(page, 'roof.obj', wavyGrid(4), 25);
  await addConstraint(page, 'Circle', 'each face');
  const { name, text } = await saved(page, 'Save scene');
  expect(name).toBe('roof.shapeup.json');
  await openText(page, 'other.obj', wavyGrid(2), 9);
  await openText(page, name, text, 25);
  expect((await state(page)).constraints).toEqual({ circle: 16 });
});

test('scripts can open scenes and meshes, and get the reason for a refusal', async ({ page }) => {
  await openPage(page);
  const loaded = await page.evaluate((text) => window.shapeUp.open(text, 'a.obj'), wavyGrid(2));
  expect(loaded?.vertices).toBe(9);
  expect((await state(page)).vertices).toBe(9);
  const refused = await page.evaluate(() =>
    window.shapeUp.open({ format: 'shape-up-scene', version: 99 }).then(
      () => null,
      (error) => error.message,
    ),
  );
  expect(refused).toContain('99');
  expect((await state(page)).vertices).toBe(9);
});

test('separate vertices at the same position are welded, can be kept apart, and are exported as they came', async ({
  page,
}) => {
  await openPage(page);
  const vertices: string[] = [];
  const faces: string[] = [];
  const corner = (x: number, y: number) => vertices.push(`v ${x} ${y} ${x * y * 0.1}`);
  for (let x = 0; x < 3; x++) {
    for (let y = 0; y < 3; y++) {
      const [a] = [corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)];
      faces.push(`f ${a} ${a + 1} ${a + 2} ${a + 3}`);
    }
  }
  const text = [...vertices, ...faces, ''].join('\n');
  await openText(page, 'loose.obj', text, 16);
  const message = page
    .getByRole('alert')
    .getByText(/^Joined vertices that lie on each other: 36 became 16 \(up to /);
  await expect(message).toBeVisible();
  await addConstraint(page, 'Plane', 'each face');
  await runToTheEnd(page);
  const { text: out } = await exported(page, 'OBJ as it came');
  expect(out.match(/^v /gm)).toHaveLength(36);
  expect(out.match(/^f .*$/gm)).toEqual(faces);
  // Vertices of adjacent faces still coincide.
  const at = known(out.match(/^v .*$/gm));
  expect(at[3]).toBe(at[4]);
  expect(at[3]).not.toBe(vertices[3]);
  expect((await exported(page, 'OBJ\\s*The')).text.match(/^v /gm)).toHaveLength(16);

  await openText(page, 'loose.obj', text, 16);
  await page.getByRole('alert').getByRole('button', { name: 'Undo' }).click();
  await waitForState(page, (now) => now.vertices === 36);
  await expect(message).toBeHidden();
  // The welded mesh was lost.
  const undo = page.getByRole('button', { name: 'Undo', exact: true });
  await expect(undo).toHaveAttribute('title', /^Undo: Separate vertices/);
  await undo.click();
  await waitForState(page, (now) => now.vertices === 16);
  await page.getByRole('button', { name: 'Redo', exact: true }).click();
  await waitForState(page, (now) => now.vertices === 36);

  // The offer would read the file again, without what was done since.
  await openText(page, 'loose.obj', text, 16);
  await expect(message).toBeVisible();
  await addConstraint(page, 'Plane', 'each face');
  await expect(message).toBeHidden();
});

test('the page asks for a file that a scene needs, and takes a pose from another file', async ({
  page,
}) => {
  await openPage(page);
  const scene = {
    ...{ format: 'shape-up-scene', version: 1, mesh: { file: 'grid.obj' }, weights: { close: 1 } },
    closeness: { to: { mesh: { file: 'ground.obj' } } },
    constraints: [{ kind: 'rigid', on: 'faces' }],
  };
  const raised = wavyGrid(4).replace(/^(v .*) \S+$/gm, '$1 2');
  await page
    .getByLabel('Open file')
    .setInputFiles([
      file('roof.shapeup.json', JSON.stringify(scene)),
      file('grid.obj', wavyGrid(4)),
    ]);
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('needs the mesh file ground.obj');
  const choose = async (name: string, text: string) => {
    const asked = page.waitForEvent('filechooser');
    await alert.getByRole('button', { name: 'Choose ground.obj' }).click();
    await (await asked).setFiles(file(name, text));
  };
  // It was read as the missing one's format, whatever it is.
  await choose('plan.off', 'OFF 0 0 0');
  await expect(alert).toContainText('plan.off is of another format: the scene needs a .obj file.');
  // A file of any name is accepted.
  await choose('plan.obj', raised);
  await waitForState(page, (now) => now.vertices === 25);
  expect((await page.evaluate(() => window.shapeUp.scene())).closeness.to.mesh.faces).toHaveLength(
    16,
  );

  await showStep(page, 'Check');
  await page.getByText('More settings').click();
  const pose = page.getByLabel('Take the pose of another file');
  await pose.setInputFiles(file('house.obj', wavyGrid(3)));
  await expect(alert).toContainText('house.obj is not a pose of the model');
  await pose.setInputFiles(file('raised.obj', raised));
  await expect(page.getByRole('status')).toHaveText('Shapes are taken from raised.obj');
  const { pose: taken } = await page.evaluate(() => window.shapeUp.scene());
  expect(taken.positions.map(([, , z]: number[]) => z)).toEqual(Array(25).fill(2));
  await page.getByRole('button', { name: 'Leave the other pose' }).click();
  await expect(page.getByRole('button', { name: 'Leave the other pose' })).toBeHidden();
});
