/** The Export dialog: the file formats, grouped by purpose. */

import { askRhino } from '../../documents/rhino/rhino-client.ts';
import { openDialog } from '../../ui/controls/dialog.ts';
import { checkbox } from '../../ui/controls/fields.ts';
import { element, setText, type Child } from '../../ui/dom.ts';
import { messageOf } from '../../solver/errors.ts';
import { pictureOf, pictureSize, type Ground } from './picture.ts';
import { convergenceSvg } from './plot-svg.ts';
import { canRecord, turntableVideo } from './turntable-video.ts';
import { isDrawn } from '../../store/state.ts';
import type { AppContext } from '../../app/context.ts';
import type { Viewport } from '../../viewport/viewport.ts';

/** Pixels per CSS pixel, and the label. */
const SCALES: [number, string][] = [
  [1, '1×'],
  [2, '2×'],
  [4, '4×'],
  [Infinity, '8k'],
];

/** The last choices. */
const picture: { scale: number; legend: boolean; ground: Ground } = {
  scale: 2,
  legend: true,
  ground: 'view',
};

const GROUNDS: [Ground, string][] = [
  ['view', 'as in the view'],
  ['white', 'white'],
  ['none', 'none (transparent)'],
];

export function showExport(app: AppContext) {
  const { store, files, viewport, actions } = app;
  const { model, document: scene, flatMap } = store.get();
  const working = element('p.working.quiet', { 'aria-live': 'polite' });

  const format = (name: string, words: string, make: () => Promise<void>, able: boolean = true) =>
    element(
      'button.format',
      { disabled: !able, onclick: () => run(make) },
      element('strong', name),
      element('span', words),
    );

  async function run(make: () => Promise<void>) {
    setText(working, 'Working …');
    try {
      await actions.settled();
      await make();
      dialog.close();
    } catch (error) {
      setText(working, messageOf(error));
    }
  }

  const saveTable = async (name: 'errors' | 'convergence' | 'angles') =>
    files.save(`-${name}.csv`, await actions.ask.table(name), 'text/csv');

  const canDraw = isDrawn(store.get());
  const curvesOnly = (model?.faces ?? 0) === 0;
  const squared = scene?.units ? `${scene.units}²` : '';
  const dialog = openDialog(
    { id: 'export', title: 'Export', light: true },
    element(
      'div.dialog-body',
      section(
        'Shape',
        format(
          'OBJ',
          `The mesh as it is now, in the order of the file${flatMap ? ', with its flat map' : ''}`,
          () => files.exportMesh(),
        ),
        model?.welded &&
          format(
            'OBJ as it came',
            'With the vertices of the file, before coincident ones were joined',
            () => files.exportUnwelded(),
          ),
        format(
          'PLY',
          'Faces and curves in full precision, for scans and 3D programs',
          () => files.exportAs('ply'),
          !curvesOnly,
        ),
        format(
          'STL',
          'Triangles in seven digits, for 3D printers',
          () => files.exportAs('stl'),
          !curvesOnly,
        ),
        format('3DM', 'For Rhino, with a layer for each group', () => saveForRhino(app)),
        format('Scene', 'The mesh with its constraints, handles and weights', () =>
          files.saveScene(),
        ),
      ),
      section(
        'Numbers',
        format(
          'Errors',
          'CSV: how flat and how round each face is',
          () => saveTable('errors'),
          !curvesOnly,
        ),
        format('Convergence', 'CSV: the energies of each iteration', () =>
          saveTable('convergence'),
        ),
        format(
          'Angles',
          'CSV: the corner angles of the faces, originally and now',
          () => saveTable('angles'),
          !curvesOnly,
        ),
      ),
      section(
        'Pictures',
        pictureOptions(viewport),
        format(
          'PNG',
          canDraw ? 'The view as it is now' : 'This browser cannot draw the view',
          async () => {
            const blob = await pictureOf(viewport, store.get(), picture);
            files.save('.png', blob, 'image/png');
          },
          canDraw,
        ),
        canRecord() &&
          format(
            'WebM',
            'A 6-second video in which the model turns once',
            async () => {
              files.save('.webm', await turntableVideo(viewport), 'video/webm');
            },
            canDraw,
          ),
        format(
          'Line drawing',
          'SVG: the visible lines, in ink on A4',
          async () => {
            const drawing = viewport.lineDrawing();
            if (!drawing) throw new Error('This browser cannot draw the view.');
            files.save('-drawing.svg', drawing, 'image/svg+xml');
          },
          canDraw,
        ),
        format('SVG', 'The plot of the convergence, on white', async () => {
          const title = `${model?.title || files.name}: convergence`;
          const svg = convergenceSvg(await actions.ask.table('convergence'), title, squared);
          files.save('-convergence.svg', svg, 'image/svg+xml');
        }),
      ),
      working,
    ),
  );
  dialog.querySelector<HTMLElement>('.format')?.focus();
}

/** Saves a 3DM file, loading its large writer. */
async function saveForRhino({ actions, files }: AppContext) {
  if (!(await files.mayExport())) return;
  const scene = await actions.ask.scene();
  const errors = await actions.ask.table('errors');
  files.save('.3dm', await askRhino((rhino) => rhino.write(scene, errors)), 'model/vnd.3dm');
}

function section(title: string, ...rows: Child[]) {
  return element('section', element('h3', title), ...rows);
}

/** The controls for the size and content of the picture. */
function pictureOptions(viewport: Viewport) {
  const size = element('span.quiet');
  const showSize = () => {
    const { width, height } = pictureSize(viewport, picture.scale);
    setText(size, `${width} × ${height} pixels`);
  };
  const { box, label: legend } = checkbox('Legend', (checked) => (picture.legend = checked));
  box.checked = picture.legend;
  const grounds = GROUNDS.map(([value, words]) =>
    element('option', { value, selected: value === picture.ground }, words),
  );
  const ground = element('select', ...grounds);
  ground.onchange = () => (picture.ground = GROUNDS[ground.selectedIndex][0]);
  showSize();
  return element(
    'div.picture',
    element(
      'fieldset',
      { 'aria-label': 'Size of the picture' },
      ...SCALES.map(([scale, name]) => {
        const choose = () => {
          picture.scale = scale;
          showSize();
        };
        const checked = scale === picture.scale;
        return element(
          'label',
          element('input', { type: 'radio', name: 'scale', checked, onchange: choose }),
          name,
        );
      }),
    ),
    legend,
    element('label', 'Background ', ground),
    size,
  );
}
