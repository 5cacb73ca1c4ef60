/** The settings: product, material, scale, sheet, joint, names and files. */

import { amountField, checkbox, choice } from '../../ui/controls/fields.ts';
import { element } from '../../ui/dom.ts';
import type { BuildPreset, BuildSettings } from '../../solver/types.ts';

/** The settings of a preset. */
const valuesOf = ({ material, thickness, scale, sheet }: BuildPreset): Partial<BuildSettings> => ({
  material,
  thickness,
  scale,
  sheet,
});

/** The least value of a setting that must be positive. */
const LEAST = 1e-9;

export function settingsForm(
  { presets }: { presets: BuildPreset[] },
  change: (change: Partial<BuildSettings>) => void,
) {
  const preset = choice(
    { id: 'parts-preset' },
    (value) => change(valuesOf(presets[Number(value)])),
    [['', 'Own settings'], ...presets.map(({ label }, k) => [String(k), label])],
  );
  const sides = ['width', 'height'].map((name) =>
    amount(`parts-${name}`, () => change({ sheet: sheet() }), LEAST),
  );
  const sheet = () => sides.map(({ field }) => field.valueAsNumber) as [number, number];
  const unitOfJoint = element('span');
  /** Each shows one setting. */
  const shows: ((settings: BuildSettings) => void)[] = [];

  /** The row of a number. */
  function number(
    key: 'alike_deg' | 'hole' | 'joint' | 'scale' | 'tab' | 'thickness',
    label: string | (string | Node)[],
    least?: number,
  ) {
    const { field, show } = amount(`parts-${key}`, (own) => change({ [key]: own }), least);
    shows.push((settings) => show(settings[key]));
    return row(label, field);
  }

  /** The row of a setting with named values. */
  function word(
    key: 'product' | 'pieces' | 'page' | 'order' | 'names' | 'dxf',
    label: string,
    options: string[][],
  ) {
    const select = choice({ id: `parts-${key}` }, (own) => change({ [key]: own }), options);
    shows.push((settings) => (select.value = settings[key]));
    return row(label, select);
  }

  function flag(key: 'print_inside' | 'outlines_only', words: string) {
    const { box, label } = checkbox(words, (own) => change({ [key]: own }));
    shows.push((settings) => (box.checked = settings[key]));
    return label;
  }

  /** Shows a field for some products only. */
  function of(products: BuildSettings['product'][], field: HTMLElement) {
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
    /** @param unit of the mesh */
    show(settings: BuildSettings, unit: string) {
      const own = presets.findIndex((preset) =>
        Object.entries(valuesOf(preset)).every(
          ([key, value]) =>
            JSON.stringify(settings[key as keyof BuildSettings]) === JSON.stringify(value),
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

/** A field for a number of at least `least`, named by the label of its row. */
const amount = (id: string, change: (value: number) => void, least: number = 0) =>
  amountField('', change, { id, min: least, 'aria-label': false });

/** @param field with an id */
const row = (label: string | (string | Node)[], field: HTMLElement) =>
  element('div.field-row', element('label', { for: field.id }, ...[label].flat()), field);
