/** Symbols of the paper in the statements of examples. */

import { element } from './dom.js';

/**
 * The text with `e_c` and `e_p` as the paper writes them.
 * @param {string} text
 * @returns {(Node | string)[]}
 */
export function withSymbols(text) {
  return text
    .split(/\be_([cp])\b/)
    .map((part, k) => (k % 2 === 0 ? part : element('var', 'e', element('sub', part))));
}
