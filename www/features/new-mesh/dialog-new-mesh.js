/**
 * The dialog of New mesh: the kinds that the solver declares, their sizes, and the mesh in the view as it is with
 * them. Until it is kept, what was open before comes back.
 */

import './new-mesh.css';
import { openDialog } from '../../ui/controls/dialog.js';
import { button, choice } from '../../ui/controls/fields.js';
import { element, setText } from '../../ui/dom.js';
import { count } from '../../ui/format.js';
import init, { newKinds, newMesh as meshOf, newPlan } from '../../pkg/build/shape_up.js';
import { messageOf } from '../../solver/messages.js';
import { UNITS } from '../../ui/units.js';
import { planForm } from './plan-form.js';
import { spanForm } from './span-form.js';
import { sizesForm } from './sizes-form.js';

/** The unit of the defaults. */
const METRE = 'm';
/** What is drawn, not a kind with sizes. */
const PLAN = { id: 'plan', label: 'From a plan' };
const SPAN = { id: 'span', label: 'Between curves' };
/** So long nobody types before a mesh is made. */
const QUIET_MS = 150;

/** @param {import("../../app/context.js").AppContext} app */
export async function newMesh({ store, solver, files, actions, alerts }) {
  await init();
  const kinds = newKinds();
  const before = await whatIsOpen();
  const open = openMesh();
  /** One work for all that is tried. */
  const work = crypto.randomUUID();
  let kept = false;
  let timer = 0;
  /** What is being made, or undefined. @type {Promise<void> | undefined} */
  let making;
  let again = false;
  /** The vertices that it stands on, which stay where they are. @type {number[]} */
  let held = [];

  const kind = choice(
    {},
    showForm,
    [...kinds, PLAN, SPAN].map(({ id, label }) => [id, label]),
  );
  const units = choice(
    {},
    convert,
    UNITS.map(({ symbol }) => [symbol, symbol]),
  );
  units.value = METRE;
  let unit = METRE;
  const said = element('p', { 'aria-live': 'polite' });
  const place = element('div.form');
  /** @type {Pick<ReturnType<typeof planForm>, "element" | "show" | "made" | "convert"> & { kept?: () => void }} */
  let form;
  const keep = button('Begin with this', keepIt, { class: 'primary' });

  /** With its steps of undo, which belong to the text that the solver sent last. */
  async function whatIsOpen() {
    const { document: scene, fileName } = store.get();
    if (!scene) return null;
    const { saved, sceneText } = solver;
    const bytes = new TextEncoder().encode(sceneText ?? (await actions.sceneText()));
    const origin = { ...files.origin, first: false, saved };
    return {
      given: [{ name: `${files.name}.shapeup.json`, bytes }],
      origin: { ...origin, title: fileName },
    };
  }

  /** The mesh whose curves there are. */
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
      const make = (/** @type {number[]} */ sizes, /** @type {string} */ units) =>
        meshOf(found.id, Float64Array.from(sizes), units);
      form = sizesForm(found, { ...given, make });
    } else form = isPlan ? planForm({ ...given, make: newPlan }) : spanForm(open, changed);
    dialog.classList.toggle('wide', isPlan);
    place.replaceChildren(form.element);
    form.show();
    changed();
  }

  /** @param {string} symbol of a unit */
  const metresOf = (symbol) => UNITS.find((one) => one.symbol === symbol)?.metres ?? 1;

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
    again = Boolean(making);
    making ??= makeOne().finally(() => {
      making = undefined;
      if (again && dialog.open) make();
    });
    return making;
  }

  async function makeOne() {
    const fields = [...place.querySelectorAll('input')];
    const wrong = fields.find((field) => !field.validity.valid);
    keep.disabled = true;
    if (wrong) {
      const label = wrong.closest('label')?.firstChild?.textContent;
      return setText(said, `${label}: ${wrong.validationMessage}`);
    }
    const { label } = chosen();
    try {
      const { text, feet } = form.made(units.value);
      const bytes = new TextEncoder().encode(text);
      const origin = { work, title: label, before };
      const loaded = await files.open([{ name: `${label}.obj`, bytes }], origin);
      const vertices = count(loaded.vertices, 'vertex', 'vertices');
      setText(said, `${count(loaded.faces, 'face')}, ${vertices}.`);
      held = feet;
      keep.disabled = false;
    } catch (error) {
      setText(said, messageOf(error));
    }
  }

  async function keepIt() {
    kept = true;
    keep.disabled = true;
    form.kept?.();
    // Whatever is pressed next is for the mesh with its feet.
    if (held.length) await hold(held);
    dialog.close();
    actions.setStatus(`New mesh: ${chosen().label}`);
  }

  /** Holds vertices where they are, as a part of the new mesh: Undo goes back to what was open before. @param {number[]} vertices */
  async function hold(vertices) {
    await actions.addHandles(vertices, true);
    const bytes = new TextEncoder().encode(await actions.sceneText());
    const origin = { work, title: chosen().label, before };
    await files.open([{ name: `${files.name}.shapeup.json`, bytes }], origin);
  }

  const dialog = openDialog(
    { id: 'new-mesh', title: 'New mesh' },
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
  dialog.addEventListener('close', async () => {
    clearTimeout(timer);
    await making;
    if (kept || !before) return;
    await files.open(before.given, before.origin).catch((error) => alerts.error(messageOf(error)));
  });
  showForm();
}
