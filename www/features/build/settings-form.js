/** The settings: product, material, scale, sheet, joint, names and files. */

import { amountField, checkbox, choice } from '../../ui/controls/fields.js';
import { element } from '../../ui/dom.js';

/** @typedef {import("../../solver/messages.js").BuildSettings} BuildSettings */
/** @typedef {import("../../solver/messages.js").BuildPreset} BuildPreset */

/** The settings of a preset. @param {BuildPreset} preset @returns {Partial<BuildSettings>} */
const valuesOf = ({ material, thickness, scale, sheet }) => ({ material, thickness, scale, sheet });

/** The least value of a setting that must be positive. */
const LEAST = 1e-9;

/**
 * @param {{ presets: BuildPreset[] }} offers
 * @param {(change: Partial<BuildSettings>) => void} change
 */
export function settingsForm({ presets }, change) {
  const preset = choice(
    { id: 'parts-preset' },
    (value) => change(valuesOf(presets[Number(value)])),
    [['', 'Own settings'], ...presets.map(({ label }, k) => [String(k), label])],
  );
  const sides = ['width', 'height'].map((name) =>
    amount(`parts-${name}`, () => change({ sheet: sheet() }), LEAST),
  );
  const sheet = () =>
    /** @type {[number, number]} */ (sides.map(({ field }) => field.valueAsNumber));
  const unitOfJoint = element('span');
  /** Each shows one setting. @type {((settings: BuildSettings) => void)[]} */
  const shows = [];

  /**
   * The row of a number.
   * @param {"alike_deg" | "hole" | "joint" | "scale" | "tab" | "thickness"} key
   * @param {string | (string | Node)[]} label
   * @param {number} [least]
   */
  function number(key, label, least) {
    const { field, show } = amount(`parts-${key}`, (own) => change({ [key]: own }), least);
    shows.push((settings) => show(settings[key]));
    return row(label, field);
  }

  /**
   * The row of a setting with named values.
   * @param {"product" | "pieces" | "page" | "order" | "names" | "dxf"} key
   * @param {string} label
   * @param {string[][]} options
   */
  function word(key, label, options) {
    const select = choice({ id: `parts-${key}` }, (own) => change({ [key]: own }), options);
    shows.push((settings) => (select.value = settings[key]));
    return row(label, select);
  }

  /**
   * @param {"print_inside" | "outlines_only"} key
   * @param {string} words
   */
  function flag(key, words) {
    const { box, label } = checkbox(words, (own) => change({ [key]: own }));
    shows.push((settings) => (box.checked = settings[key]));
    return label;
  }

  /**
   * Shows a field for some products only.
   * @param {BuildSettings["product"][]} products
   * @param {HTMLElement} field
   */
  function of(products, field) {
    shows.push(({ product }) => (field.hidden = !products.includes(product)));
    return field;
  }

  const form = element(
    'div.parts-settings',
    word('product', 'Make', [
      ['panels', 'Panels'],
      ['fins', 'Fins along the edges'],
      ['paper', 'Paper model'],
    ]),
    of(
      ['paper'],
      word('pieces', 'Pieces', [
        ['nets', 'Nets'],
        ['strips', 'Strips'],
        ['across', 'Strips, other way'],
      ]),
    ),
    of(['paper'], number('tab', 'Tabs, mm')),
    of(['paper'], flag('print_inside', 'Print on the inside')),
    row('Material', preset),
    number('scale', 'Scale 1 :', LEAST),
    number('thickness', 'Thickness, mm'),
    row('Sheet width, mm', sides[0].field),
    row('Sheet height, mm', sides[1].field),
    of(['panels'], number('joint', ['Joint', unitOfJoint])),
    of(['panels', 'fins'], number('hole', 'Holes, mm')),
    of(['fins'], number('alike_deg', 'Nodes alike, °')),
    element(
      'details',
      element('summary', 'Names and files'),
      word('order', 'Order', [
        ['size', 'Fewest sheets'],
        ['names', 'By name'],
      ]),
      word('names', 'Names', [
        ['index', 'P0, P1, P2 ...'],
        ['rows', 'Rows and columns'],
      ]),
      word('dxf', 'Drawings', [
        ['r2000', 'DXF 2000'],
        ['r12', 'DXF R12, for old machines'],
      ]),
      word('page', 'Pages of the PDF', [
        ['sheet', 'Sheet size'],
        ['a4', 'A4'],
        ['a3', 'A3'],
      ]),
      flag('outlines_only', 'Outlines only, without names'),
    ),
  );
  return {
    form,
    /**
     * @param {BuildSettings} settings
     * @param {string} unit of the mesh
     */
    show(settings, unit) {
      const own = presets.findIndex((preset) =>
        Object.entries(valuesOf(preset)).every(
          ([key, value]) =>
            JSON.stringify(settings[/** @type {keyof BuildSettings} */ (key)]) ===
            JSON.stringify(value),
        ),
      );
      preset.value = own < 0 ? '' : String(own);
      preset.options[0].hidden = own >= 0;
      for (const show of shows) show(settings);
      sides.forEach(({ show }, k) => show(settings.sheet[k]));
      unitOfJoint.textContent = `, ${unit}`;
    },
  };
}

/**
 * A field for a number of at least `least`, named by the label of its row.
 * @param {string} id
 * @param {(value: number) => void} change
 * @param {number} [least]
 */
const amount = (id, change, least = 0) =>
  amountField('', change, { id, min: least, 'aria-label': false });

/**
 * @param {string | (string | Node)[]} label
 * @param {HTMLElement} field with an id
 */
const row = (label, field) =>
  element('div.field-row', element('label', { for: field.id }, ...[label].flat()), field);
