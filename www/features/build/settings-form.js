/** What is asked once: material, scale, sheet, joint, names, files. */

import { checkbox, choice } from '../../ui/controls/fields.js';
import { element } from '../../ui/dom.js';

/** @typedef {import("../../solver/messages.js").BuildSettings} BuildSettings */
/** @typedef {import("../../solver/messages.js").BuildPreset} BuildPreset */

/** What a preset says beside its name. @param {BuildPreset} preset @returns {Partial<BuildSettings>} */
const valuesOf = ({ material, thickness, scale, sheet }) => ({ material, thickness, scale, sheet });

/**
 * A list of words of which a setting is one.
 * @param {"order" | "names" | "dxf"} key
 * @param {(change: Partial<BuildSettings>) => void} change
 * @param {string[][]} options
 */
const wordChoice = (key, change, options) =>
  choice({ id: `parts-${key}` }, (word) => change({ [key]: word }), options);

const ORDERS = [
  ['size', 'Fewest sheets'],
  ['names', 'As they are named'],
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
  const scale = number('parts-scale', (scale) => change({ scale }));
  const thickness = number('parts-thickness', (thickness) => change({ thickness }), true);
  const width = number('parts-width', (own) =>
    change({ sheet: [own, height.field.valueAsNumber] }),
  );
  const height = number('parts-height', (own) =>
    change({ sheet: [width.field.valueAsNumber, own] }),
  );
  const joint = number('parts-joint', (joint) => change({ joint }), true);
  const order = wordChoice('order', change, ORDERS);
  const names = wordChoice('names', change, NAMES);
  const dxf = wordChoice('dxf', change, DXF);
  const only = checkbox('Outlines only, without names', (own) => change({ outlines_only: own }));
  const unitOfJoint = element('span');

  const form = element(
    'div.parts-settings',
    row('Material', 'parts-preset', preset),
    row('Scale 1 :', 'parts-scale', scale.field),
    row('Thickness, mm', 'parts-thickness', thickness.field),
    row('Sheet width, mm', 'parts-width', width.field),
    row('Sheet height, mm', 'parts-height', height.field),
    row(['Joint', unitOfJoint], 'parts-joint', joint.field),
    element(
      'details',
      element('summary', 'Names and files'),
      row('Order', 'parts-order', order),
      row('Names', 'parts-names', names),
      row('Drawings', 'parts-dxf', dxf),
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
 * A number above zero, or from it.
 * @param {string} id
 * @param {(value: number) => void} change
 * @param {boolean} [fromZero]
 */
function number(id, change, fromZero = false) {
  let shown = '';
  const field = element('input', {
    ...{ id, type: 'number', min: '0', step: 'any' },
    onchange: () => {
      const value = field.valueAsNumber;
      if (field.validity.valid && (fromZero ? value >= 0 : value > 0)) change(value);
      else field.value = shown;
    },
  });
  return {
    field,
    /** @param {number} value */
    show(value) {
      shown = String(value);
      if (document.activeElement !== field) field.value = shown;
    },
  };
}

/**
 * @param {string | (string | Node)[]} label
 * @param {string} id
 * @param {HTMLElement} field
 */
const row = (label, id, field) =>
  element('div.field-row', element('label', { for: id }, ...[label].flat()), field);
