/** Beside what is dragged: how far it has moved, in the unit of the mesh. */

import { element, setText } from './dom.js';
import { lengthUnit, number } from './format.js';
import { ROUNDING } from './rounding.js';

/**
 * @param {import("./viewport.js").Viewport} viewport
 * @param {import("./state.js").Store} store
 */
export function showMoved({ element: view, heldPlace }, store) {
  const label = element('p', { id: 'moved', hidden: true });
  view.after(label);
  store.subscribe(['moved'], (state) => {
    const { moved } = state;
    const place = moved && heldPlace(moved.by);
    label.hidden = !moved || !place;
    if (!moved || !place) return;
    setText(label, movedInWords(moved.by, state));
    const { offsetLeft, offsetTop, clientWidth, clientHeight } = view;
    const within = (/** @type {number} */ at, /** @type {number} */ room) =>
      Math.max(4, Math.min(at, room - 4));
    const left = within(place[0] + 22, clientWidth - label.offsetWidth);
    const top = within(place[1] + 18, clientHeight - label.offsetHeight);
    label.style.translate = `${offsetLeft + left}px ${offsetTop + top}px`;
  });
}

/**
 * The parts of a displacement that are not nothing.
 * @param {number[]} by
 * @param {Readonly<import("./state.js").State>} state
 */
export function movedInWords(by, { document, size }) {
  const far = Math.hypot(...by);
  const { unit, factor } = lengthUnit(far, document?.units ?? '');
  const parts = by.flatMap((part, axis) => {
    if (Math.abs(part) <= Math.max(ROUNDING * size, 1e-3 * far)) return [];
    const sign = part > 0 ? '+' : '';
    return [`${'xyz'[axis]} ${sign}${number(part * factor)}`];
  });
  return parts.length > 0 ? `${parts.join('  ')} ${unit}`.trim() : `0 ${unit}`.trim();
}
