/** The dialog More formats: the file formats, grouped by purpose. */

import { signal, useComputed } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { ComponentProps } from 'preact';
import { exportAs, exportForRhino, exportMesh, exportUnwelded } from '../../documents/exports.ts';
import { messageOf } from '../../solver/errors.ts';
import { showDialog, type InDialog } from '../../store/show-dialog.tsx';
import { isDrawn } from '../../store/state.ts';
import { mapInWords } from '../../store/stale-map.ts';
import { useApp } from '../../store/use-app.ts';
import { Checkbox, Choice } from '../../ui/components/fields.tsx';
import { oneAtATime } from '../../ui/once.ts';
import { pictureOf, pictureSize, type Ground } from './picture.ts';
import { canRecord, turntableVideo } from './turntable-video.ts';
import type { AppContext } from '../../app/context.ts';

/** Pixels per CSS pixel, and the label. */
const SCALES: [number, string][] = [
  [1, '1×'],
  [2, '2×'],
  [4, '4×'],
  [Infinity, '8k'],
];

const GROUNDS: [Ground, string][] = [
  ['view', 'as in the view'],
  ['white', 'white'],
  ['none', 'none (transparent)'],
];

/** The last choices. */
const picture = signal<{ scale: number; legend: boolean; ground: Ground }>({
  scale: 2,
  legend: true,
  ground: 'view',
});

/** Whether a file is being made, perhaps of a dialog that was closed meanwhile. */
const isMaking = signal(false);
/** Why the last file could not be made, empty if it could; null where no dialog shows it. */
const problem = signal<string | null>(null);

/** Makes a file. A second one meanwhile would be the same, or a second film of the same view. */
const makeOne = oneAtATime(async ({ actions }: AppContext, file: () => Promise<unknown>) => {
  isMaking.value = true;
  try {
    await actions.settled();
    await file();
  } finally {
    isMaking.value = false;
  }
});

export function showExport(app: AppContext) {
  showDialog(app, { id: 'export', title: 'More formats', light: true }, ExportDialog);
}

function ExportDialog({ close }: InDialog) {
  const app = useApp();
  const { store, files, viewport, actions } = app;
  const { model } = store.state;
  const canDraw = isDrawn(store.state);
  const curvesOnly = (model?.faces ?? 0) === 0;
  const mapped = useComputed(() => mapInWords(app, store.state)).value;

  useEffect(() => {
    problem.value = '';
    return () => {
      problem.value = null;
    };
  }, []);

  /** Makes a file, after which the dialog is closed. */
  const make = (file: () => Promise<unknown>) => async () => {
    const made = makeOne(app, file);
    if (!made) return;
    problem.value = '';
    try {
      await made;
      close();
    } catch (error) {
      if (problem.peek() === null) await actions.reportErrors(Promise.reject(error));
      else problem.value = messageOf(error);
    }
  };
  const makeTable = (name: 'errors' | 'convergence' | 'angles') =>
    make(() => files.save(`-${name}.csv`, 'text/csv', () => actions.ask.table(name)));

  return (
    <div class="dialog-body">
      <section>
        <h3>Back to Rhino</h3>
        <Format
          autofocus
          name="OBJ"
          words={`The mesh as it is now, in the order of the file${mapped ? `, ${mapped}` : ''}`}
          onClick={make(() => exportMesh(app))}
        />
        {model?.welded && (
          <Format
            name="OBJ as it came"
            words="With the vertices of the file, before coincident ones were joined"
            onClick={make(() => exportUnwelded(app))}
          />
        )}
        <Format
          name="3DM"
          words="For Rhino, with a layer for each group"
          onClick={make(() => exportForRhino(app))}
        />
      </section>
      <section>
        <h3>Other programs</h3>
        <Format
          name="PLY"
          words="Faces and curves in full precision, for scans and 3D programs"
          disabled={curvesOnly}
          onClick={make(() => exportAs(app, 'ply'))}
        />
        <Format
          name="STL"
          words="Triangles in seven digits, for 3D printers"
          disabled={curvesOnly}
          onClick={make(() => exportAs(app, 'stl'))}
        />
        <Format
          name="Scene"
          words="The mesh with its constraints, handles and weights"
          onClick={make(() => files.saveScene())}
        />
      </section>
      <section>
        <h3>Cut sheets</h3>
        <Format
          name="Build"
          words="The parts on sheets as DXF, SVG and PDF, with tables and key drawings"
          disabled={curvesOnly}
          onClick={() => {
            close();
            actions.look({ docked: 'parts' });
          }}
        />
      </section>
      <section>
        <h3>Numbers</h3>
        <Format
          name="Errors"
          words="CSV: how flat and how round each face is"
          disabled={curvesOnly}
          onClick={makeTable('errors')}
        />
        <Format
          name="Convergence"
          words="CSV: the energies of each iteration"
          onClick={makeTable('convergence')}
        />
        <Format
          name="Angles"
          words="CSV: the corner angles of the faces, originally and now"
          disabled={curvesOnly}
          onClick={makeTable('angles')}
        />
      </section>
      <section>
        <h3>Pictures</h3>
        <PictureOptions />
        <Format
          name="PNG"
          words={canDraw ? 'The view as it is now' : 'This browser cannot draw the view'}
          disabled={!canDraw}
          onClick={make(() =>
            files.save('.png', 'image/png', () => pictureOf(viewport, store.get(), picture.value)),
          )}
        />
        {canRecord() && (
          <Format
            name="WebM"
            words="A 6-second video in which the model turns once"
            disabled={!canDraw}
            onClick={make(() =>
              files.save('.webm', 'video/webm', (replaced) => turntableVideo(viewport, replaced)),
            )}
          />
        )}
        <Format
          name="Line drawing"
          words="SVG: the visible lines, in ink on A4"
          disabled={!canDraw}
          onClick={make(async () => {
            const drawing = viewport.lineDrawing();
            if (!drawing) throw new Error('This browser cannot draw the view.');
            await files.save('-drawing.svg', 'image/svg+xml', () => drawing);
          })}
        />
      </section>
      <p class="working quiet" aria-live="polite">
        {isMaking.value ? 'Working …' : problem.value}
      </p>
    </div>
  );
}

/** The button that saves a file of one format. */
const Format = ({
  name,
  words,
  onClick,
  ...rest
}: Omit<ComponentProps<'button'>, 'role'> & { name: string; words: string }) => (
  // It keeps the focus, unlike one that is disabled.
  <button
    type="button"
    class="format"
    aria-disabled={isMaking.value}
    onClick={isMaking.value ? undefined : onClick}
    {...rest}
  >
    <strong>{name}</strong>
    <span>{words}</span>
  </button>
);

/** The controls for the size and content of the picture. */
function PictureOptions() {
  const { viewport } = useApp();
  const { scale, legend, ground } = picture.value;
  const choose = (change: Partial<typeof picture.value>) => {
    picture.value = { ...picture.value, ...change };
  };
  const { width, height } = pictureSize(viewport, scale);
  return (
    <div class="picture">
      <fieldset aria-label="Size of the picture">
        {SCALES.map(([value, label]) => (
          <label key={value}>
            <input
              type="radio"
              name="scale"
              checked={value === scale}
              onChange={() => choose({ scale: value })}
            />
            {label}
          </label>
        ))}
      </fieldset>
      <Checkbox
        label="Legend"
        checked={legend}
        onCheck={(checked) => choose({ legend: checked })}
      />
      <label>
        Background{' '}
        <Choice
          value={ground}
          options={GROUNDS}
          onChoose={(value) => choose({ ground: value as Ground })}
        />
      </label>
      <span class="quiet">{`${width} × ${height} pixels`}</span>
    </div>
  );
}
