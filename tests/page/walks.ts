// The states of the page, and how each is reached from the one before.

import type { Page } from '@playwright/test';
import {
  addConstraint,
  hidePanels,
  openExample,
  openText,
  openVariations,
  runToTheEnd,
  showStep,
  tool,
} from './actions.ts';
import { file, vault, wavyGrid } from './meshes.ts';
import { dragVertex, expect, screenOf, state, waitForState } from './support.ts';

async function selectAllFaces(page: Page) {
  await view(page).focus();
  await page.keyboard.press('3');
  await page.keyboard.press('Control+a');
  await waitForState(page, (now) => now.selection.faces.length === 16);
}

/** The first handle that is not fixed, as a vertex. */
async function softHandle(page: Page) {
  const { handles } = await state(page);
  return handles.find(({ fixed }) => !fixed)?.vertex ?? NaN;
}

/** Brings a tab of the analysis to the front. */
async function showTab(page: Page, name: string) {
  await showStep(page, 'Check');
  await page.getByRole('tablist', { name: 'Analysis' }).getByRole('tab', { name }).click();
  await expect(page.getByRole('tabpanel', { name })).toBeVisible();
}

/** Makes all graphics contexts unavailable to the page. */
export const withoutGraphics = (page: Page) =>
  page.addInitScript(() => {
    const prototype: { getContext(kind: string, options?: unknown): unknown } =
      HTMLCanvasElement.prototype;
    const { getContext } = prototype;
    prototype.getContext = function (kind, options) {
      return kind === '2d' ? getContext.call(this, kind, options) : null;
    };
    Object.defineProperty(Navigator.prototype, 'gpu', { value: undefined });
  });

const escape = (page: Page) => page.keyboard.press('Escape');
const view = (page: Page) => page.getByRole('application', { name: '3D view' });

/**
 * A state of the page: its name, how it is reached from the one before, how it is left for the next
 * one, and optionally the only project that tests it, because most states look the same on a phone.
 */
type State = {
  name: string;
  reach?: (page: Page) => unknown;
  leave?: (page: Page) => unknown;
  only?: string;
};

/** Walks through the page, each starting from a newly opened page. */
export const walks: Record<string, State[]> = {
  'a presentation': [
    {
      name: 'its steps',
      only: 'desktop',
      reach: async (page) => {
        await page.getByRole('button', { name: 'Present', exact: true }).click();
        await page.getByRole('button', { name: 'Add this view' }).click();
        await page.getByLabel('Text of step 1').fill('What is said beside it.');
        await page.getByLabel('Text of step 1').blur();
      },
    },
    {
      name: 'the stage',
      only: 'desktop',
      reach: async (page) => {
        await page.getByRole('button', { name: 'Start', exact: true }).click();
        await expect(page.getByRole('region', { name: 'Presentation' })).toContainText('1 of 1');
      },
      leave: escape,
    },
  ],
  'what opens from the tools': [
    { name: 'the start' },
    {
      name: 'the tools of a phone',
      only: 'phone',
      reach: async (page) => {
        await page.getByRole('button', { name: 'More', exact: true }).click();
        await expect(page.getByRole('button', { name: 'Faces' })).toBeVisible();
      },
      leave: escape,
    },
    {
      name: 'the menu of examples',
      reach: async (page) => {
        await tool(page, 'Examples');
        await expect(page.getByRole('menuitem', { name: 'Hypar' })).toBeVisible();
      },
      leave: escape,
    },
    {
      name: 'recent works',
      only: 'desktop',
      reach: async (page) => {
        await tool(page, 'Open recent');
        await expect(page.getByRole('menu', { name: 'Open recent' })).toBeVisible();
      },
      leave: escape,
    },
    {
      name: 'the dialog of Export',
      only: 'desktop',
      reach: async (page) => {
        await tool(page, 'More formats');
        await expect(page.getByRole('dialog', { name: 'More formats' })).toBeVisible();
      },
      leave: escape,
    },
    {
      name: 'the dialog of Share',
      only: 'desktop',
      reach: async (page) => {
        await page.getByRole('button', { name: 'Share' }).click();
        await expect(page.getByRole('dialog', { name: 'Share' })).toBeVisible();
      },
      leave: escape,
    },
    {
      name: 'help',
      reach: async (page) => {
        await tool(page, 'Help');
        await expect(page.getByRole('dialog', { name: 'Mouse and keys' })).toBeVisible();
      },
      leave: escape,
    },
  ],
  'around the view': [
    {
      name: 'the menu of views',
      reach: async (page) => {
        await waitForState(page, (now) => now.renderer.startsWith('web'));
        await page.getByRole('button', { name: 'Views' }).click();
        await expect(page.getByRole('button', { name: 'Ground grid' })).toBeVisible();
      },
      leave: escape,
    },
    {
      name: 'the menu of what is under the pointer',
      reach: async (page) => {
        const soft = await softHandle(page);
        await page.mouse.click(...(await screenOf(page, soft)), { button: 'right' });
        await expect(page.getByRole('menu', { name: 'What is here' })).toBeVisible();
      },
      leave: escape,
    },
    {
      name: 'the Select tool',
      reach: async (page) => {
        await tool(page, 'Select');
        await page.getByRole('button', { name: 'Paint' }).click();
        await expect(page.getByRole('slider', { name: 'Brush radius' })).toBeVisible();
      },
      leave: async (page) => {
        await view(page).focus();
        await page.keyboard.press('v');
      },
    },
    {
      name: 'something to drop',
      only: 'desktop',
      reach: async (page) => {
        const data = await page.evaluateHandle(() => {
          const transfer = new DataTransfer();
          transfer.items.add(new File(['v 0 0 0'], 'dropped.obj'));
          return transfer;
        });
        await page.dispatchEvent('body', 'dragover', { dataTransfer: data });
        await expect(page.getByText('Drop to open')).toBeVisible();
      },
      leave: (page) => page.dispatchEvent('body', 'dragleave'),
    },
    {
      name: 'an error',
      reach: async (page) => {
        await page
          .getByLabel('Open file')
          .setInputFiles(file('broken.obj', 'this is not a mesh\n'));
        await expect(page.getByRole('alert')).toContainText('broken.obj');
      },
    },
  ],
  'the panels of the first example': [
    {
      name: 'solved, with the first hint',
      reach: async (page) => {
        await waitForState(page, (now) => now.converged);
        await expect(page.getByText(/^The corners of each panel lie on a circle/)).toBeVisible();
      },
    },
    {
      name: 'at its start',
      reach: async (page) => {
        await page.getByRole('button', { name: 'Reset' }).click();
        await expect(page.getByText('This is the original.')).toBeVisible();
      },
    },
    {
      name: 'energies, all settings and the legend',
      reach: async (page) => {
        await showStep(page, 'Shape');
        await page.getByText('More settings').click();
        await page.getByRole('button', { name: 'Step' }).click();
        await waitForState(page, (now) => now.iteration === 1);
      },
      leave: (page) => page.getByText('More settings').click(),
    },
    { name: 'the angles', only: 'desktop', reach: (page) => showTab(page, 'Angles') },
    {
      name: 'the worst elements',
      reach: async (page) => {
        await showTab(page, 'Worst');
        await expect(page.getByRole('table', { name: 'Worst elements' })).toBeVisible();
      },
    },
    {
      name: 'the log',
      only: 'desktop',
      reach: (page) => showTab(page, 'Log'),
    },
    {
      name: 'converged',
      reach: async (page) => {
        await hidePanels(page);
        await page.getByRole('button', { name: 'Run' }).click();
        await expect(page.getByRole('status')).toHaveText(/^Converged after/);
      },
    },
    {
      name: 'parts and sheets',
      reach: async (page) => {
        await showStep(page, 'Build');
        await page.getByRole('button', { name: 'Build', exact: true }).click();
        await waitForState(page, (now) => now.build !== null);
        await expect(page.getByRole('group', { name: 'Sheets' }).getByRole('img')).not.toHaveCount(
          0,
        );
      },
      leave: async (page) => {
        await page.getByRole('button', { name: 'Close build: parts and sheets' }).click();
        await hidePanels(page);
      },
    },
    {
      name: 'the second hint',
      only: 'desktop',
      reach: async (page) => {
        await waitForState(page, (now) => now.renderer.startsWith('web'));
        const soft = await softHandle(page);
        await dragVertex(page, soft, [10, -20]);
        await expect(page.getByText('Press Reset to go back to the original')).toBeVisible();
      },
    },
    {
      name: 'the third hint',
      only: 'desktop',
      reach: async (page) => {
        await page.getByRole('button', { name: 'Reset' }).click();
        await expect(page.getByText('This is the original.')).toBeVisible();
        await page.getByRole('button', { name: 'Run' }).click();
        await expect(page.getByText('open a mesh of your own')).toBeVisible();
      },
    },
  ],
  'a mesh of one’s own': [
    {
      name: 'the question for its unit',
      reach: async (page) => {
        await openText(page, 'roof.obj', wavyGrid(6), 49);
        await showStep(page, 'Open');
        await expect(page.getByRole('button', { name: 'Yes', exact: true })).toBeVisible();
      },
      leave: hidePanels,
    },
    {
      name: 'its report',
      reach: async (page) => {
        await openText(page, 'grid.obj', `${wavyGrid(4)}f 1 2\n`, 25);
        await showStep(page, 'Open');
        await expect(page.getByText('1 kind of problem in the file')).toBeVisible();
      },
      leave: hidePanels,
    },
    {
      name: 'parts and sheets',
      reach: async (page) => {
        await showStep(page, 'Build');
        await page.getByRole('button', { name: 'Build', exact: true }).click();
        await waitForState(page, (now) => now.build !== null);
      },
      leave: async (page) => {
        await page.getByRole('button', { name: 'Close build' }).click();
        await hidePanels(page);
      },
    },
    {
      name: 'a selection and its menu',
      reach: async (page) => {
        await selectAllFaces(page);
        await page.getByRole('button', { name: /select by/ }).click();
        await expect(page.getByRole('dialog', { name: 'Select' })).toBeVisible();
      },
    },
    {
      name: 'a question of the menu of selecting',
      only: 'desktop',
      reach: async (page) => {
        const menu = page.getByRole('dialog', { name: 'Select' });
        await menu.getByRole('button', { name: 'By error…' }).click();
        await menu.getByRole('spinbutton', { name: 'Above' }).fill('-1');
        await menu.getByRole('button', { name: 'Find' }).click();
        await expect(menu.getByRole('spinbutton', { name: 'Above' })).toHaveAttribute(
          'aria-invalid',
        );
      },
    },
    {
      name: 'the dialog of a new constraint',
      reach: async (page) => {
        await escape(page);
        await showStep(page, 'Shape');
        await page.getByRole('button', { name: 'Add constraint' }).click();
        const dialog = page.getByRole('dialog', { name: 'New constraint' });
        await dialog.getByRole('radio', { name: 'Plane', exact: true }).check();
        await dialog.getByText(/shapes? do(es)? not fit here/).click();
        await expect(dialog.getByRole('button', { name: 'Add', exact: true })).toBeEnabled();
      },
      leave: escape,
    },
    {
      name: 'constraints and a handle with their parameters',
      reach: async (page) => {
        await addConstraint(page, 'Plane', 'each face');
        await selectAllFaces(page);
        await page.keyboard.press('h');
        await waitForState(page, (now) => now.handles.length === 25);
        await showStep(page, 'Shape');
        const row = page.getByRole('list', { name: 'Constraints' }).getByRole('listitem').first();
        await row.getByRole('button', { name: /parameters/ }).click();
      },
    },
    {
      name: 'the numbers of several handles, one of them refused',
      reach: async (page) => {
        await showStep(page, 'Move');
        const details = page.getByRole('group', { name: 'Selected handles' });
        const field = details.getByRole('spinbutton', { name: 'Target x' });
        await expect(field).toHaveAttribute('placeholder', 'mixed');
        await field.fill('high');
        await field.press('Enter');
        await expect(field).toHaveValue('high');
        const refusal = '“high” is not a length. Expected 1.5, 1/3 or +0.5.';
        await expect(field).toHaveJSProperty('validationMessage', refusal);
      },
      leave: escape,
    },
    {
      name: 'a lesson that is written',
      only: 'desktop',
      reach: async (page) => {
        await page.getByRole('button', { name: 'Write a lesson' }).click();
        await expect(page.getByRole('dialog', { name: 'Lesson' })).toBeVisible();
      },
    },
  ],
  'new panels': [
    {
      name: 'laid out, with both choices at the boundary',
      reach: async (page) => {
        await openText(page, 'vault.obj', vault(14), 225);
        await page.getByRole('button', { name: 'New panels along the curvature' }).click();
        const card = page.getByRole('region', { name: 'New panels' });
        await expect(card.getByRole('definition').nth(1)).toHaveText(/will move/);
      },
    },
    {
      name: 'a size that is refused',
      reach: async (page) => {
        const card = page.getByRole('region', { name: 'New panels' });
        await card.getByLabel('Side').fill('1000');
        await card.getByLabel('Side').press('Enter');
        await expect(card.getByRole('button', { name: /^Not possible: / })).toBeVisible();
      },
      leave: escape,
    },
  ],
  'tools and dialogs': (
    [
      ['the command palette', (page) => page.keyboard.press('Control+k'), 'Commands'],
      ['a new mesh', (page) => tool(page, 'New mesh'), 'New mesh'],
      [
        'a plan that is drawn',
        async (page) => {
          await page.keyboard.press('Control+k');
          await page.keyboard.type('drawn plan');
          await page.keyboard.press('Enter');
        },
        'New mesh',
      ],
      [
        'a new mesh between curves',
        async (page) => {
          await tool(page, 'New mesh');
          await page
            .getByRole('dialog', { name: 'New mesh' })
            .getByLabel('Shape')
            .selectOption({ label: 'Between curves' });
        },
        'New mesh',
      ],
      ['refining', (page) => tool(page, 'Refine'), 'Refine'],
      ['a change of the mesh', (page) => tool(page, 'Edit mesh'), 'Edit mesh'],
      [
        'how to cite',
        async (page) => {
          await tool(page, 'Help');
          await page.getByRole('button', { name: 'Cite' }).click();
        },
        'Cite',
      ],
    ] as [string, (page: Page) => Promise<unknown>, string][]
  )
    .map<State>(([name, open, dialog]) => ({
      name,
      only: 'desktop',
      reach: async (page) => {
        await open(page);
        await expect(page.getByRole('dialog', { name: dialog })).toBeVisible();
        // To its end, where nothing is below what stays in sight.
        await page.evaluate(() => {
          for (const one of document.querySelectorAll('dialog[open], dialog[open] *'))
            one.scrollTop = one.scrollHeight;
        });
      },
      leave: async (page) => {
        await escape(page);
        await escape(page);
        await expect(page.getByRole('dialog')).toHaveCount(0);
      },
    }))
    .concat([
      {
        name: 'a preset of weights that may not suit the mesh',
        only: 'desktop',
        reach: (page) => page.getByRole('combobox', { name: 'Preset' }).selectOption({ index: 1 }),
      },
      {
        name: 'the card of curvature',
        only: 'desktop',
        reach: async (page) => {
          await tool(page, 'Curvature');
          await expect(page.getByRole('region', { name: 'Curvature' })).toBeVisible();
        },
        leave: escape,
      },
      {
        name: 'a section, and the measuring tape',
        only: 'desktop',
        reach: async (page) => {
          await page.getByRole('button', { name: 'Views' }).click();
          await page.getByRole('button', { name: 'Section plane' }).click();
          await page.getByRole('button', { name: 'Measure a distance' }).click();
          await expect(page.getByRole('slider', { name: 'Position of the section' })).toBeVisible();
        },
        leave: async (page) => {
          await escape(page);
          await page.getByRole('button', { name: 'End the section' }).click();
        },
      },
      {
        name: 'variations of an exact shape',
        only: 'desktop',
        reach: async (page) => {
          const panel = await openVariations(page, 4);
          await panel.getByRole('slider').first().press('ArrowRight');
          await expect(panel.getByRole('button', { name: 'Keep', exact: true })).toBeEnabled();
        },
        leave: (page) => page.getByRole('button', { name: 'Close variations' }).click(),
      },
      {
        name: 'the report of Build',
        only: 'desktop',
        reach: async (page) => {
          await page.getByRole('button', { name: 'Build', exact: true }).click();
          await waitForState(page, (now) => now.build !== null);
          await page.getByRole('button', { name: 'Report' }).click();
          await expect(page.getByRole('dialog', { name: 'Report' })).toBeVisible();
        },
        leave: escape,
      },
    ]),
  'other examples': [
    {
      name: 'a lesson, of which a line is over the view',
      only: 'phone',
      reach: async (page) => {
        await openExample(page, 'Exercise: a glass roof');
        await expect(page.getByRole('button', { name: /goals satisfied/ })).toBeVisible();
      },
    },
    {
      name: 'the flat map',
      reach: async (page) => {
        await openExample(page, 'Mask');
        await showStep(page, 'Check');
        await page.getByRole('button', { name: 'Flatten' }).click();
        await expect(page.getByRole('heading', { name: 'Flat map' })).toBeVisible();
      },
      leave: (page) => page.getByRole('button', { name: 'Back to the model' }).click(),
    },
    {
      name: 'a lesson whose goals are missed',
      reach: async (page) => {
        await openExample(page, 'Exercise: a glass roof of flat panes');
        await runToTheEnd(page);
        await showStep(page, 'Open');
        const lesson = page.getByRole('region', { name: 'Lesson' });
        await expect(lesson).toContainText('0 of 2 goals satisfied');
      },
    },
    {
      name: 'a lesson whose goals are met',
      only: 'desktop',
      reach: async (page) => {
        for (const [energy, value] of [
          ['Shape weight', '10000'],
          ['Close weight', '50'],
        ]) {
          const field = page.getByRole('spinbutton', { name: energy });
          await field.fill(value);
          await field.press('Enter');
          await runToTheEnd(page);
        }
        const lesson = page.getByRole('region', { name: 'Lesson' });
        await expect(lesson).toContainText('Passed: 2 goals satisfied');
      },
    },
  ],
  'what went wrong': [
    {
      name: 'a truncated link',
      reach: async (page) => {
        await page.goto('./#link=CAAqrVip');
        await expect(page.getByRole('alert')).toContainText('probably truncated');
      },
    },
    {
      name: 'a solver that was restarted',
      only: 'desktop',
      reach: async (page) => {
        const [worker] = page.workers();
        await worker.evaluate(() => {
          setTimeout(() => {
            throw new Error('out of order');
          });
        });
        await expect(page.getByRole('alert')).toContainText('was restarted');
      },
    },
    {
      name: 'a graphics context that was lost for good',
      only: 'desktop',
      reach: async (page) => {
        // Every new canvas loses its context too, as soon as it exists: once one has drawn, earlier
        // losses are forgiven.
        await page.evaluate(() => {
          const place = document.querySelector('#viewport') as HTMLElement;
          const lose = () =>
            place.querySelector('canvas')?.dispatchEvent(new Event('webglcontextlost'));
          new MutationObserver(lose).observe(place, { childList: true });
          lose();
        });
        await expect(page.getByText('No 3D view')).toBeVisible();
      },
    },
  ],
};
