/** The form for the sizes of a kind of mesh that the solver declares. */

import { sizeField } from '../../ui/controls/size-field.js';
import { element, setText } from '../../ui/dom.js';

/** @typedef {import("../../pkg/engine/shape_up.js").NewKind} NewKind */
/** @typedef {import("../../pkg/engine/shape_up.js").Size} Size */

/**
 * @param {NewKind} kind
 * @param {object} given
 * @param {string} given.unit
 * @param {number} given.metre in that unit
 * @param {() => void} given.onchange
 * @param {(sizes: number[], units: string) => string} given.make
 */
export function sizesForm(kind, { unit, metre, onchange, make }) {
  /** The default value, converted from metres to the chosen unit. @param {Size} size */
  const first = ({ of, default: value }) => (of === 'length' ? rounded(value * metre) : value);
  const rows = kind.sizes.map((size) => sizeField(size, { value: first(size), unit, onchange }));
  const sizes = element('div.sizes', ...rows);
  const fields = () => [...sizes.querySelectorAll('input')];
  return {
    element: element('div.kind', element('p.quiet', kind.summary), sizes),
    show() {},
    /** @param {string} units @returns {{ text: string, supports: number[] }} */
    made(units) {
      const sizes = fields().map((field) => field.valueAsNumber);
      return { text: make(sizes, units), supports: [] };
    },
    /**
     * Converts the sizes to another unit.
     * @param {string} symbol
     * @param {number} factor
     */
    convert(symbol, factor) {
      for (const field of fields()) {
        const shown = field.nextElementSibling;
        if (!(shown instanceof HTMLElement) || shown.dataset.of !== 'length') continue;
        setText(shown, symbol);
        if (field.value) field.value = String(rounded(field.valueAsNumber * factor));
      }
    },
  };
}

/** @param {number} value */
const rounded = (value) => Number(value.toPrecision(4));
