/** The form for the sizes of a kind of mesh that the solver declares. */

import { sizeField } from '../../ui/controls/size-field.ts';
import { element, setText } from '../../ui/dom.ts';
import type { NewKind, Size } from '../../pkg/engine/shape_up.js';

/** @param given.metre in that unit */
export function sizesForm(
  kind: NewKind,
  {
    unit,
    metre,
    onchange,
    make,
  }: {
    unit: string;
    metre: number;
    onchange: () => void;
    make: (sizes: number[], units: string) => string;
  },
) {
  /** The default value, converted from metres to the chosen unit. */
  const first = ({ of, default: value }: Size) =>
    of === 'length' ? rounded(value * metre) : value;
  const rows = kind.sizes.map((size) => sizeField(size, { value: first(size), unit, onchange }));
  const sizes = element('div.sizes', ...rows);
  const fields = () => [...sizes.querySelectorAll('input')];
  return {
    element: element('div.kind', element('p.quiet', kind.summary), sizes),
    show() {},
    made(units: string): { text: string; supports: number[] } {
      const sizes = fields().map((field) => field.valueAsNumber);
      return { text: make(sizes, units), supports: [] };
    },
    /** Converts the sizes to another unit. */
    convert(symbol: string, factor: number) {
      for (const field of fields()) {
        const shown = field.nextElementSibling;
        if (!(shown instanceof HTMLElement) || shown.dataset.of !== 'length') continue;
        setText(shown, symbol);
        if (field.value) field.value = String(rounded(field.valueAsNumber * factor));
      }
    },
  };
}

const rounded = (value: number) => Number(value.toPrecision(4));
