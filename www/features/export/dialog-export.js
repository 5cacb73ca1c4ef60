/** The Export dialog: the file formats, grouped by purpose. */

import { openDialog } from '../../ui/controls/dialog.js';
import { checkbox } from '../../ui/controls/fields.js';
import { element, setText } from '../../ui/dom.js';
import { messageOf } from '../../solver/messages.js';
import { pictureOf, pictureSize } from './picture.js';
import { convergenceSvg } from './plot-svg.js';
import { canRecord, turntableVideo } from './turntable-video.js';
import { isDrawn } from '../../store/state.js';

/** Pixels per CSS pixel, and the label. @type {[number, string][]} */
const SCALES = [
  [1, '1×'],
  [2, '2×'],
  [4, '4×'],
  [Infinity, '8k'],
];

/** The last choices. */
/** @type {{ scale: number, legend: boolean, ground: import("./picture.js").Ground }} */
const picture = { scale: 2, legend: true, ground: 'view' };

/** @type {[import("./picture.js").Ground, string][]} */
const GROUNDS = [
  ['view', 'as in the view'],
  ['white', 'white'],
  ['none', 'none (transparent)'],
];

/** @param {import("../../app/context.js").AppContext} app */
export function showExport(app) {
  const { store, files, viewport, actions } = app;
  const { model, document: scene, flatMap } = store.get();
  const working = element('p.working.quiet', { 'aria-live': 'polite' });

  /**
   * @param {string} name
   * @param {string} words
   * @param {() => Promise<void>} make
   * @param {boolean} [able]
   */
  const format = (name, words, make, able = true) =>
    element(
      'button.format',
      { disabled: !able, onclick: () => run(make) },
      element('strong', name),
      element('span', words),
    );

  /** @param {() => Promise<void>} make */
  async function run(make) {
    setText(working, 'Working …');
    try {
      await make();
      dialog.close();
    } catch (error) {
      setText(working, messageOf(error));
    }
  }

  const saveTable = async (/** @type {"errors" | "convergence" | "angles"} */ name) =>
    files.save(`-${name}.csv`, await actions.table(name), 'text/csv');

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
          const svg = convergenceSvg(await actions.table('convergence'), title, squared);
          files.save('-convergence.svg', svg, 'image/svg+xml');
        }),
      ),
      working,
    ),
  );
  /** @type {HTMLElement | null} */ (dialog.querySelector('.format'))?.focus();
}

/**
 * Saves a 3DM file, loading its large writer.
 * @param {import("../../app/context.js").AppContext} app
 */
async function saveForRhino({ actions, files }) {
  if (!(await files.mayExport())) return;
  const { askRhino } = await import('../../documents/rhino/rhino-client.js');
  const scene = await actions.sceneText();
  const errors = await actions.table('errors');
  files.save('.3dm', await askRhino({ type: 'write', scene, errors }), 'model/vnd.3dm');
}

/**
 * @param {string} title
 * @param {...import("../../ui/dom.js").Child} rows
 */
function section(title, ...rows) {
  return element('section', element('h3', title), ...rows);
}

/**
 * The controls for the size and content of the picture.
 * @param {import("../../viewport/viewport.js").Viewport} viewport
 */
function pictureOptions(viewport) {
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
