/** A row for a declared setting: its name, the control for its values, and its unit. */

import { element } from '../dom.ts';
import type { BuildSetting } from '../../solver/types.ts';
import { amountField, checkbox, choice } from './fields.ts';

/** A value of a setting, as in a scene. */
export type SettingValue = number | string | boolean | null;

/** @param id of the control */
export function declaredField(
  { label, summary: title, form, absent }: BuildSetting,
  id: string,
  change: (value: SettingValue) => unknown,
) {
  const unit = element('span.unit', { 'aria-hidden': 'true' });
  /** The unit as a part of the control's name. */
  const spoken = element('span.visually-hidden');
  const row = (field: HTMLElement, ...more: HTMLElement[]) =>
    element(
      'div.field-row',
      { title },
      element('label', { for: id }, label, spoken),
      field,
      ...more,
    );

  switch (form.type) {
    case 'switch': {
      const { box, label: own } = checkbox(label, change, { title });
      return { row: own, show: (value: SettingValue) => (box.checked = value === true) };
    }
    case 'choice': {
      const words = form.options.map((option) => [option.word, option.label, option.summary]);
      const options = absent ? [['', absent], ...words] : words;
      const select = choice({ id }, (word) => change(word || null), options);
      return {
        row: row(select),
        show: (value: SettingValue) => (select.value = String(value ?? '')),
      };
    }
    case 'text': {
      const field = element('input', { type: 'text', id, onchange: () => change(field.value) });
      return {
        row: row(field),
        show(value: SettingValue) {
          if (document.activeElement !== field) field.value = String(value ?? '');
        },
      };
    }
    case 'number': {
      const [min, max] = form.range;
      const attributes = {
        id,
        min,
        max,
        'aria-label': false,
        ...(absent && { placeholder: 'auto' }),
      };
      const onempty = absent ? () => change(null) : undefined;
      const { field, show } = amountField('', change, attributes, onempty);
      return {
        row: row(field, unit),
        /** @param ofMesh the unit of the mesh */
        show(value: SettingValue, ofMesh: string) {
          show(typeof value === 'number' ? value : null);
          const symbol = { '': '', mesh: ofMesh, mm: 'mm', degrees: '°' }[form.unit];
          unit.textContent = symbol;
          spoken.textContent = symbol && `, ${symbol}`;
        },
      };
    }
  }
}
