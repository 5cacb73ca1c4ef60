/**
 * The dialog of New mesh: the kinds that the solver declares, their sizes, and the mesh in the view as it is with
 * them. Until it is kept, what was open before comes back.
 */

import './new-mesh.css';
import { openDialog } from '../../ui/controls/dialog.js';
import { button, choice } from '../../ui/controls/fields.js';
import { sizeField } from '../../ui/controls/size-field.js';
import { element, setText } from '../../ui/dom.js';
import { count } from '../../ui/format.js';
import { messageOf } from '../../solver/messages.js';
import { UNITS } from '../../ui/units.js';

/** @typedef {import("../../pkg/solver/shape_up.js").NewKind} NewKind */
/** @typedef {import("../../pkg/solver/shape_up.js").Size} Size */

/** The unit of the defaults. */
const METRE = 'm';
/** So long nobody types before a mesh is made. */
const QUIET_MS = 150;

/** @param {import("../../app/context.js").AppContext} app */
export async function newMesh({ store, files, actions, alerts }) {
  const kinds = await actions.newKinds();
  const before = await whatIsOpen();
  /** One work for all that is tried. */
  const work = crypto.randomUUID();
  let kept = false;
  let timer = 0;
  /** What is being made, or undefined. @type {Promise<void> | undefined} */
  let making;
  let again = false;

  const kind = choice(
    {},
    showSizes,
    kinds.map(({ id, label }) => [id, label]),
  );
  const units = choice(
    {},
    convert,
    UNITS.map(({ symbol }) => [symbol, symbol]),
  );
  units.value = METRE;
  let unit = METRE;
  const summary = element('p.quiet');
  const sizes = element('div.sizes');
  const said = element('p', { 'aria-live': 'polite' });
  const keep = button('Begin with this', keepIt, { class: 'primary' });

  async function whatIsOpen() {
    const { document: scene, fileName } = store.get();
    if (!scene) return null;
    const bytes = new TextEncoder().encode(await actions.sceneText());
    const origin = { ...files.origin, first: false };
    return {
      given: [{ name: `${files.name}.shapeup.json`, bytes }],
      origin: { ...origin, title: fileName },
    };
  }

  const chosen = () => kinds.find(({ id }) => id === kind.value) ?? kinds[0];
  const fields = () => [...sizes.querySelectorAll('input')];

  function showSizes() {
    const { summary: words, sizes: declared } = chosen();
    setText(summary, words);
    const field = (/** @type {Size} */ size) =>
      sizeField(size, { value: inUnit(size.default, size.of), unit, onchange: changed });
    sizes.replaceChildren(...declared.map(field));
    changed();
  }

  /** @param {string} symbol of a unit */
  const metresOf = (symbol) => UNITS.find((one) => one.symbol === symbol)?.metres ?? 1;
  /** A default, in metres, in the unit that is chosen. @param {number} value @param {Size["of"]} of */
  const inUnit = (value, of) =>
    of === 'length' ? Number((value / metresOf(unit)).toPrecision(4)) : value;

  /** The same sizes in the unit that is now chosen. */
  function convert() {
    const factor = metresOf(unit) / metresOf(units.value);
    unit = units.value;
    for (const field of fields()) {
      const shown = field.nextElementSibling;
      if (!(shown instanceof HTMLElement) || shown.dataset.of !== 'length') continue;
      setText(shown, unit);
      if (field.value) field.value = String(Number((field.valueAsNumber * factor).toPrecision(4)));
    }
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
    const wrong = fields().find((field) => !field.validity.valid);
    keep.disabled = true;
    if (wrong) {
      const label = wrong.closest('label')?.firstChild?.textContent;
      return setText(said, `${label}: ${wrong.validationMessage}`);
    }
    const values = fields().map((field) => field.valueAsNumber);
    const { id, label } = chosen();
    try {
      const text = await actions.newMesh(id, values, units.value);
      const bytes = new TextEncoder().encode(text);
      const loaded = await files.open([{ name: `${label}.obj`, bytes }], { work, title: label });
      const vertices = count(loaded.vertices, 'vertex', 'vertices');
      setText(said, `${count(loaded.faces, 'face')}, ${vertices}.`);
      keep.disabled = false;
    } catch (error) {
      setText(said, messageOf(error));
    }
  }

  async function keepIt() {
    kept = true;
    dialog.close();
    actions.setStatus(`New mesh: ${chosen().label}`);
  }

  const dialog = openDialog(
    { id: 'new-mesh', title: 'New mesh' },
    element(
      'div.dialog-body',
      element('label', element('span', 'Shape'), kind),
      summary,
      element('label', element('span', 'Unit'), units),
      sizes,
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
  showSizes();
}
