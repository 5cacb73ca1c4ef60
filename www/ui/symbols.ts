/** Symbols of the paper in the statements of examples. */

import { element } from './dom.ts';

/** Sets `e_c` and `e_p` in a text as in the paper. */
export function withSymbols(text: string): (Node | string)[] {
  return text
    .split(/\be_([cp])\b/)
    .map((part, k) => (k % 2 === 0 ? part : element('var', 'e', element('sub', part))));
}
