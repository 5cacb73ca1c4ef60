/** The settings: product, material, scale, sheet, joint, names and files. */

import { amountField, checkbox, choice } from '../../ui/controls/fields.js';
import { element } from '../../ui/dom.js';

/** @typedef {import("../../solver/messages.js").BuildSettings} BuildSettings */
/** @typedef {import("../../solver/messages.js").BuildPreset} BuildPreset */

/** The settings of a preset. @param {BuildPreset} preset @returns {Partial<BuildSettings>} */
const valuesOf = ({ material, thickness, scale, sheet }) => ({ material, thickness, scale, sheet });

/**
 * A select element for a setting with named values.
 * @param {"product" | "pieces" | "page" | "order" | "names" | "dxf"} key
 * @param {(change: Partial<BuildSettings>) => void} change
 * @param {string[][]} options
 */
const wordChoice = (key, change, options) =>
  choice({ id: `parts-${key}` }, (word) => change({ [key]: word }), options);

/** The least value of a setting that must be positive. */
const LEAST = 1e-9;

const PRODUCTS = [
  ['panels', 'Panels'],
  ['fins', 'Fins along the edges'],
  ['paper', 'Paper model'],
];
const PIECES = [
  ['nets', 'Nets'],
  ['strips', 'Strips'],
  ['across', 'Strips, other way'],
];
const PAGES = [
  ['sheet', 'Sheet size'],
  ['a4', 'A4'],
  ['a3', 'A3'],
];
const ORDERS = [
  ['size', 'Fewest sheets'],
  ['names', 'By name'],
];
const NAMES = [
  ['index', 'P0, P1, P2 ...'],
  ['rows', 'Rows and columns'],
];
const DXF = [
  ['r2000', 'DXF 2000'],
  ['r12', 'DXF R12, for old machines'],
];

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
  const scale = amount('parts-scale', (scale) => change({ scale }), LEAST);
  const thickness = amount('parts-thickness', (thickness) => change({ thickness }));
  const width = amount(
    'parts-width',
    (own) => change({ sheet: [own, height.field.valueAsNumber] }),
    LEAST,
  );
  const height = amount(
    'parts-height',
    (own) => change({ sheet: [width.field.valueAsNumber, own] }),
    LEAST,
  );
  const joint = amount('parts-joint', (joint) => change({ joint }));
  const product = wordChoice('product', change, PRODUCTS);
  const pieces = wordChoice('pieces', change, PIECES);
  const page = wordChoice('page', change, PAGES);
  const tab = amount('parts-tab', (tab) => change({ tab }));
  const hole = amount('parts-hole', (hole) => change({ hole }));
  const alike = amount('parts-alike', (own) => change({ alike_deg: own }));
  const inside = checkbox('Print on the inside', (own) => change({ print_inside: own }));
  const order = wordChoice('order', change, ORDERS);
  const names = wordChoice('names', change, NAMES);
  const dxf = wordChoice('dxf', change, DXF);
  const only = checkbox('Outlines only, without names', (own) => change({ outlines_only: own }));
  const unitOfJoint = element('span');
  /** Fields that apply to some products only. @type {HTMLElement[]} */
  const onlyOf = [];
  const of = (/** @type {string} */ products, /** @type {HTMLElement} */ own) => {
    own.dataset.of = products;
    onlyOf.push(own);
    return own;
  };

  const form = element(
    'div.parts-settings',
    row('Make', 'parts-product', product),
    of('paper', row('Pieces', 'parts-pieces', pieces)),
    of('paper', row('Tabs, mm', 'parts-tab', tab.field)),
    of('paper', inside.label),
    row('Material', 'parts-preset', preset),
    row('Scale 1 :', 'parts-scale', scale.field),
    row('Thickness, mm', 'parts-thickness', thickness.field),
    row('Sheet width, mm', 'parts-width', width.field),
    row('Sheet height, mm', 'parts-height', height.field),
    of('panels', row(['Joint', unitOfJoint], 'parts-joint', joint.field)),
    of('panels fins', row('Holes, mm', 'parts-hole', hole.field)),
    of('fins', row('Nodes alike, °', 'parts-alike', alike.field)),
    element(
      'details',
      element('summary', 'Names and files'),
      row('Order', 'parts-order', order),
      row('Names', 'parts-names', names),
      row('Drawings', 'parts-dxf', dxf),
      row('Pages of the PDF', 'parts-page', page),
      only.label,
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
      product.value = settings.product;
      for (const own of onlyOf) own.hidden = !own.dataset.of?.split(' ').includes(settings.product);
      pieces.value = settings.pieces;
      page.value = settings.page;
      tab.show(settings.tab);
      hole.show(settings.hole);
      alike.show(settings.alike_deg);
      inside.box.checked = settings.print_inside;
      scale.show(settings.scale);
      thickness.show(settings.thickness);
      width.show(settings.sheet[0]);
      height.show(settings.sheet[1]);
      joint.show(settings.joint);
      order.value = settings.order;
      names.value = settings.names;
      dxf.value = settings.dxf;
      only.box.checked = settings.outlines_only;
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
 * @param {string} id
 * @param {HTMLElement} field
 */
const row = (label, id, field) =>
  element('div.field-row', element('label', { for: id }, ...[label].flat()), field);
