/**
 * The New mesh dialog: the kinds that the solver declares, their sizes, and the mesh in the view.
 * Unless the mesh is kept, closing the dialog reopens the previous document.
 */

import './new-mesh.css';
import { newId } from '../../documents/recent-documents.ts';
import { openDialog } from '../../ui/controls/dialog.ts';
import { button, choice } from '../../ui/controls/fields.ts';
import { element, setText } from '../../ui/dom.ts';
import { count } from '../../ui/format.ts';
import init, { newKinds, newMesh as meshOf, newPlan } from '../../pkg/engine/shape_up.js';
import { messageOf } from '../../solver/errors.ts';
import { UNITS } from '../../ui/units.ts';
import { planForm } from './plan-form.ts';
import { spanForm } from './span-form.ts';
import { sizesForm } from './sizes-form.ts';
import type { AppContext } from '../../app/context.ts';

/** The unit of the defaults. */
const METRE = 'm';
/** Choices that are not kinds of the solver. */
export const PLAN = { id: 'plan', label: 'From a plan' };
const SPAN = { id: 'span', label: 'Between curves' };
/** Pause in typing after which the mesh is made. */
const QUIET_MS = 150;

/** @param first what is chosen at first; by default the first kind */
export async function newMesh(
  { store, solver, files, actions, alerts }: AppContext,
  first?: { id: string },
) {
  await init({ module_or_path: solver.module });
  const kinds = newKinds();
  const before = await files.asItIs();
  const open = openMesh();
  /** One autosave entry for all trials. */
  const work = newId();
  let kept = false;
  /** Set while a change waits to be made. */
  let timer = 0;
  /** The mesh being made, if any. */
  let making: Promise<void> | undefined;
  let again = false;
  /** The vertices on which the mesh stands, to be fixed. */
  let held: number[] = [];

  const kind = choice(
    {},
    showForm,
    [...kinds, PLAN, SPAN].map(({ id, label }) => [id, label]),
  );
  if (first) kind.value = first.id;
  const units = choice(
    {},
    convert,
    UNITS.map(({ symbol }) => [symbol, symbol]),
  );
  units.value = METRE;
  let unit = METRE;
  const said = element('p', { 'aria-live': 'polite' });
  const place = element('div.form');
  let form: Pick<ReturnType<typeof planForm>, 'element' | 'show' | 'made' | 'convert'> & {
    kept?: () => void;
  };
  const keep = button('Create mesh', keepIt, { class: 'primary' });

  /** The open mesh, whose curves the span form uses. */
  function openMesh() {
    const { document: scene } = store.get();
    const { geometry } = solver;
    if (!scene || !geometry) return null;
    const { positions, connectivity } = geometry;
    return { positions: positions.slice(), connectivity, units: scene.units, up: scene.up };
  }

  const chosen = () => [...kinds, PLAN, SPAN].find(({ id }) => id === kind.value) ?? PLAN;

  function showForm() {
    const found = kinds.find(({ id }) => id === kind.value);
    const given = { unit, metre: 1 / metresOf(unit), onchange: changed };
    const isPlan = kind.value === PLAN.id;
    if (found) {
      const make = (sizes: number[], units: string) =>
        meshOf(found.id, Float64Array.from(sizes), units);
      form = sizesForm(found, { ...given, make });
    } else form = isPlan ? planForm({ ...given, make: newPlan }) : spanForm(open, changed);
    dialog.classList.toggle('wide', isPlan);
    place.replaceChildren(form.element);
    form.show();
    changed();
  }

  /** @param symbol of a unit */
  const metresOf = (symbol: string) => UNITS.find((one) => one.symbol === symbol)?.metres ?? 1;

  function convert() {
    form.convert(units.value, metresOf(unit) / metresOf(units.value));
    unit = units.value;
    changed();
  }

  function changed() {
    clearTimeout(timer);
    timer = window.setTimeout(make, QUIET_MS);
  }

  function make() {
    clearTimeout(timer);
    timer = 0;
    again = Boolean(making);
    making ??= makeOne().finally(() => {
      making = undefined;
      if (again && dialog.open) void make();
    });
    return making;
  }

  async function makeOne() {
    const fields = [...place.querySelectorAll('input')];
    const wrong = fields.find((field) => !field.validity.valid);
    if (wrong) {
      keep.disabled = true;
      const label = wrong.closest('label')?.firstChild?.textContent;
      return setText(said, `${label}: ${wrong.validationMessage}`);
    }
    const { label } = chosen();
    try {
      const { text, supports } = form.made(units.value);
      const bytes = new TextEncoder().encode(text);
      const link = before?.origin.link;
      const origin = { work, title: label, before, trial: true, link };
      const loaded = await files.open([{ name: `${label}.obj`, bytes }], origin);
      if (!loaded) return void (keep.disabled = true);
      const vertices = count(loaded.vertices, 'vertex', 'vertices');
      setText(said, `${count(loaded.faces, 'face')}, ${vertices}.`);
      held = supports;
      keep.disabled = false;
    } catch (error) {
      keep.disabled = true;
      setText(said, messageOf(error));
    }
  }

  async function keepIt() {
    // A number typed last is reported when its field loses the focus to this button. It stays enabled
    // while the mesh is made: a slow press would otherwise be lost.
    if (timer) await make();
    while (making) await making;
    if (keep.disabled || !dialog.open) return;
    kept = true;
    keep.disabled = true;
    form.kept?.();
    // The next command acts on the mesh with its fixed vertices.
    if (held.length) await hold(held);
    else files.keepTrial();
    dialog.close();
    actions.setStatus(`New mesh: ${chosen().label}`);
  }

  /** Fixes vertices; Undo still reopens the previous document. */
  async function hold(vertices: number[]) {
    await actions.addHandles(vertices, true);
    const bytes = new TextEncoder().encode(await actions.ask.scene());
    const origin = { work, title: chosen().label, before };
    await files.open([{ name: `${files.name}.shapeup.json`, bytes }], origin);
  }

  const dialog = openDialog(
    { id: 'new-mesh', title: 'New mesh', lasts: true },
    element(
      'div.dialog-body',
      element(
        'div.choices',
        element('label', element('span', 'Shape'), kind),
        element('label', element('span', 'Unit'), units),
      ),
      place,
      element(
        'footer',
        said,
        element(
          'div.dialog-buttons',
          keep,
          button('Cancel', () => dialog.close()),
        ),
      ),
    ),
  );
  // A model that is opened from elsewhere stays: it is neither a trial nor the one before.
  const isOther = () => ![work, before?.origin.work].includes(files.origin.work);
  const stop = files.on('opened', () => isOther() && dialog.close());
  dialog.addEventListener('close', async () => {
    stop();
    clearTimeout(timer);
    await making;
    if (kept || !before || isOther()) return;
    await files.open(before.given, before.origin).catch((error) => alerts.error(messageOf(error)));
  });
  showForm();
}
