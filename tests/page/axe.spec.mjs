// What axe says of every state of the page, in both themes: nothing.

import AxeBuilder from '@axe-core/playwright';
import { addConstraint, hidePanels, openExample, openText, showPanel, tool } from './actions.mjs';
import { file, quadScene, wavyGrid } from './meshes.mjs';
import { dragVertex, expect, openPage, screenOf, state, test, waitForState } from './support.mjs';

/** What axe complains about, in a line each. */
async function complaintsOf(page) {
  const { violations } = await new AxeBuilder({ page }).analyze();
  return violations.flatMap(({ id, impact, nodes }) =>
    nodes.map(({ target, failureSummary }) => {
      const reason = failureSummary.split('\n').slice(1, 3).join(' ').trim();
      return `${impact} ${id} at ${target.join(' ')}: ${reason}`;
    }),
  );
}

/** A scene that is never at rest. */
function endlessScene() {
  const scene = JSON.parse(quadScene(40));
  scene.constraints = [{ kind: 'circle', on: 'faces' }];
  scene.solver = { tolerance: 0, accelerator: 'none' };
  return JSON.stringify(scene);
}

const grid = (page) => openText(page, 'grid.obj', wavyGrid(4), 25);

async function selectAllFaces(page) {
  await page.getByRole('application', { name: '3D view' }).focus();
  await page.keyboard.press('3');
  await page.keyboard.press('Control+a');
  await waitForState(page, (now) => now.selection.faces.length === 16);
}

/** Brings a tab of the analysis to the front. */
async function showTab(page, name) {
  await showPanel(page, 'Energies and display');
  await page.getByRole('tablist', { name: 'Analysis' }).getByRole('tab', { name }).click();
  await expect(page.getByRole('tabpanel', { name })).toBeVisible();
}

/** Leaves the page without anything that draws. */
const withoutGraphics = (page) =>
  page.addInitScript(() => {
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
      return kind === '2d' ? getContext.call(this, kind, ...rest) : null;
    };
    Object.defineProperty(Navigator.prototype, 'gpu', { value: undefined });
  });

/** The states of the page: how each is reached from the page that was just opened. */
const STATES = {
  start: () => {},
  'converged, with the second hint': async (page) => {
    await page.getByRole('button', { name: 'Run' }).click();
    await expect(page.getByRole('status')).toHaveText(/^Converged after/);
  },
  'the third hint': async (page) => {
    await waitForState(page, (now) => now.renderer !== 'none');
    const soft = (await state(page)).handles.find((handle) => !handle.fixed);
    await dragVertex(page, soft.vertex, [10, -20]);
    await expect(page.getByText('open a mesh of your own')).toBeVisible();
  },
  'a mesh of one’s own, with its report': async (page) => {
    await openText(page, 'grid.obj', `${wavyGrid(4)}f 1 2\n`, 25);
    await showPanel(page, 'Model');
    await expect(page.getByText('1 problem in the file')).toBeVisible();
  },
  'an error': async (page) => {
    await page.getByLabel('Open file').setInputFiles(file('broken.obj', 'this is not a mesh\n'));
    await expect(page.getByRole('alert')).toContainText('broken.obj');
  },
  'the menu of examples': async (page) => {
    await tool(page, 'Examples');
    await expect(page.getByRole('menuitem', { name: 'Hypar' })).toBeVisible();
  },
  'recent works': async (page) => {
    await tool(page, 'Open recent');
    await expect(page.getByRole('menu', { name: 'Open recent' })).toBeVisible();
  },
  'the Select tool': async (page) => {
    await hidePanels(page);
    await tool(page, 'Select');
    await page.getByRole('button', { name: 'Paint' }).click();
    await expect(page.getByRole('slider', { name: 'Brush radius' })).toBeVisible();
  },
  'a selection and its menu': async (page) => {
    await grid(page);
    await selectAllFaces(page);
    await page.getByRole('button', { name: /select by/ }).click();
    await expect(page.getByRole('dialog', { name: 'Select' })).toBeVisible();
  },
  'a question of the menu of selecting': async (page) => {
    await grid(page);
    await selectAllFaces(page);
    await page.getByRole('button', { name: /select by/ }).click();
    const menu = page.getByRole('dialog', { name: 'Select' });
    await menu.getByRole('button', { name: 'By error…' }).click();
    await menu.getByRole('spinbutton', { name: 'Above' }).fill('-1');
    await menu.getByRole('button', { name: 'Find' }).click();
    await expect(menu.getByRole('spinbutton', { name: 'Above' })).toHaveAttribute('aria-invalid');
  },
  'the dialog of a new constraint': async (page) => {
    await grid(page);
    await selectAllFaces(page);
    await showPanel(page, 'Model');
    await page.getByRole('button', { name: 'Add constraint' }).click();
    const dialog = page.getByRole('dialog', { name: 'New constraint' });
    await dialog.getByRole('radio', { name: 'Plane', exact: true }).check();
    await dialog.getByText(/shapes? do(es)? not fit here/).click();
    await expect(dialog.getByRole('button', { name: 'Add', exact: true })).toBeEnabled();
  },
  'constraints and a handle with their parameters': async (page) => {
    await grid(page);
    await addConstraint(page, 'Plane', 'each face');
    await selectAllFaces(page);
    await page.keyboard.press('h');
    await waitForState(page, (now) => now.handles.length === 25);
    await showPanel(page, 'Model');
    const row = page.getByRole('list', { name: 'Constraints' }).getByRole('listitem').first();
    await row.getByRole('button', { name: /parameters/ }).click();
  },
  'energies, all settings and the legend': async (page) => {
    await showPanel(page, 'Energies and display');
    await page.getByText('More settings').click();
    await page.getByRole('button', { name: 'Step' }).click();
    await waitForState(page, (now) => now.iteration === 1);
  },
  'the dialog of Export': async (page) => {
    await tool(page, 'More formats');
    await expect(page.getByRole('dialog', { name: 'Export' })).toBeVisible();
  },
  'the dialog of Share': async (page) => {
    await page.getByRole('button', { name: 'Share' }).click();
    await expect(page.getByRole('dialog', { name: 'Share' })).toBeVisible();
  },
  help: async (page) => {
    await tool(page, 'Help');
    await expect(page.getByRole('dialog', { name: 'Mouse and keys' })).toBeVisible();
  },
  'an experiment that has been run': async (page) => {
    await openExample(page, 'Animal, pressed flat');
    await showPanel(page, 'Model');
    await page.getByRole('button', { name: 'Compare methods' }).click();
    const dialog = page.getByRole('dialog');
    await dialog.getByLabel('At most').fill('2');
    await dialog.getByRole('button', { name: 'Run all' }).click();
    await expect(dialog.getByRole('status')).toHaveText('All methods have ended.');
  },
  'the flat map': async (page) => {
    await openExample(page, 'Mask');
    await showPanel(page, 'Energies and display');
    await page.getByRole('button', { name: 'Parametrize' }).click();
    await expect(page.getByRole('heading', { name: 'Flat map' })).toBeVisible();
  },
  'the menu of views': async (page) => {
    await waitForState(page, (now) => now.renderer !== 'none');
    await page.getByRole('button', { name: 'Views' }).click();
    await expect(page.getByRole('button', { name: 'Ground grid' })).toBeVisible();
  },
  'before and after, side by side': async (page) => {
    await page.goto('./#example=fig-05-planar');
    await waitForState(page, (now) => now.vertices === 2135 && now.renderer !== 'none');
    await showPanel(page, 'Model');
    await page.getByRole('button', { name: 'Before and after' }).click();
    await expect(page.getByRole('slider', { name: 'Divider' })).toBeVisible();
  },
  'the angles': async (page) => showTab(page, 'Angles'),
  'the worst elements': async (page) => {
    await showTab(page, 'Worst');
    await expect(page.getByRole('table', { name: 'Worst elements' })).toBeVisible();
  },
  'the log': async (page) => showTab(page, 'Log'),
  'a lesson that is written': async (page) => {
    await grid(page);
    await showPanel(page, 'Model');
    await page.getByRole('button', { name: 'Write a lesson' }).click();
    await expect(page.getByRole('dialog', { name: 'Lesson' })).toBeVisible();
  },
  'the menu of what is under the pointer': async (page) => {
    await waitForState(page, (now) => now.renderer !== 'none');
    const soft = (await state(page)).handles.find((handle) => !handle.fixed);
    await page.mouse.click(...(await screenOf(page, soft.vertex)), { button: 'right' });
    await expect(page.getByRole('menu', { name: 'What is here' })).toBeVisible();
  },
  'something to drop': async (page) => {
    const data = await page.evaluateHandle(() => {
      const transfer = new DataTransfer();
      transfer.items.add(new File(['v 0 0 0'], 'dropped.obj'));
      return transfer;
    });
    await page.dispatchEvent('body', 'dragover', { dataTransfer: data });
    await expect(page.getByText('Drop to open')).toBeVisible();
  },
  'a solver that was restarted': async (page) => {
    const [worker] = page.workers();
    await worker.evaluate(() => {
      setTimeout(() => {
        throw new Error('out of order');
      });
    });
    await expect(page.getByRole('alert')).toContainText('was restarted');
  },
  'a graphics context that was lost for good': async (page) => {
    await openPage(page, 'backend=webgl2');
    // Each new one too, before it has drawn: a picture that was there makes up for those that were lost.
    await page.evaluate(() => {
      const lose = () => {
        const canvas = document.querySelector('#viewport canvas');
        canvas?.dispatchEvent(new Event('webglcontextlost'));
        if (!document.body.innerText.includes('No 3D picture')) setTimeout(lose, 5);
      };
      lose();
    });
    await expect(page.getByText('No 3D picture')).toBeVisible();
  },
};

/** Whether the window is a phone's. */
const isPhone = () => test.info().project.name === 'phone';

/** What a phone shows as every other window does. */
const SAME_ON_A_PHONE = new Set([
  'the third hint',
  'recent works',
  'a question of the menu of selecting',
  'the dialog of Export',
  'the dialog of Share',
  'an experiment that has been run',
  'the angles',
  'the log',
  'a lesson that is written',
  'something to drop',
  'a solver that was restarted',
  'a graphics context that was lost for good',
]);

/** In both themes. */
async function expectNothing(page) {
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
    expect(await complaintsOf(page), colorScheme).toEqual([]);
  }
}

for (const [name, reach] of Object.entries(STATES)) {
  test(`axe: ${name}`, async ({ page }) => {
    test.skip(isPhone() && SAME_ON_A_PHONE.has(name), 'asked of the desktop');
    await openPage(page);
    await reach(page);
    await expectNothing(page);
  });
}

test('axe: before anything but the HTML is there', async ({ page }) => {
  await page.route('**/*.wasm', () => {});
  await page.goto('./');
  await expectNothing(page);
});

// With graphics, what draws without a card leaves axe no time.
test('axe: running', async ({ page }) => {
  await withoutGraphics(page);
  await openPage(page);
  await openText(page, 'endless.shapeup.json', endlessScene(), 41 * 41);
  await page.getByRole('button', { name: 'Run' }).click();
  await waitForState(page, (now) => now.running && now.iteration > 0);
  await expectNothing(page);
  expect((await state(page)).running).toBe(true);
});

test('axe: without graphics', async ({ page }) => {
  await withoutGraphics(page);
  await openPage(page);
  await expect(page.getByText('No 3D picture')).toBeVisible();
  await expectNothing(page);
});

test('axe: the tools of a phone', async ({ page }) => {
  await openPage(page);
  const more = page.getByRole('button', { name: 'More', exact: true });
  test.skip(!(await more.isVisible()), 'for a phone');
  await more.click();
  await expect(page.getByRole('button', { name: 'Faces' })).toBeVisible();
  await expectNothing(page);
});

for (const search of ['', 'no such thing']) {
  test(`axe: the gallery${search && ', with nothing found'}`, async ({ page }) => {
    await page.goto('./gallery.html');
    await page.getByRole('searchbox', { name: 'Search' }).fill(search);
    const cards = page.getByRole('article');
    await (search ? expect(cards).toHaveCount(0) : expect(cards.first()).toBeVisible());
    await expectNothing(page);
  });
}

test('axe: projections', async ({ page }) => {
  await page.goto('./projections.html');
  await page.getByRole('button', { name: 'Step' }).click();
  await expect(page.getByRole('status')).toContainText('Step I, iteration 1');
  await expectNothing(page);
});
