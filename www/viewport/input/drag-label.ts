/** Label beside a dragged handle: its displacement, in the unit of the mesh. */

import { RENEW_MS, element, setText, throttled } from '../../ui/dom.ts';
import { lengthUnit, number } from '../../ui/format.ts';
import { ROUNDING } from '../../ui/rounding.ts';
import type { Viewport } from '../viewport.ts';
import type { State, Store } from '../../store/state.ts';

export function showMoved(viewport: Viewport, store: Store) {
  const label = element('p', { id: 'moved', hidden: true });
  viewport.element.after(label);
  const write = () => {
    const { moved } = store.get();
    if (moved) setText(label, displacementInWords(moved.by, store.get()));
  };
  const writeSoon = throttled(RENEW_MS, write);
  store.subscribe(['moved'], ({ moved }) => {
    const position = moved && viewport.heldPosition(moved.by);
    const wasHidden = label.hidden;
    label.hidden = !position;
    if (!position) return;
    if (wasHidden) write();
    else writeSoon();
    // On the side with more room, without measuring the label: that would force a layout.
    const [x, y] = position;
    label.style.translate =
      x > viewport.width / 2 ? `calc(${x - 22}px - 100%) ${y + 18}px` : `${x + 22}px ${y + 18}px`;
  });
}

/** Formats the components of a displacement that are not negligible. */
function displacementInWords(by: number[], { document, model }: Readonly<State>) {
  const far = Math.hypot(...by);
  const { unit, factor } = lengthUnit(far, document?.units ?? '');
  const parts = by.flatMap((part, axis) => {
    if (Math.abs(part) <= Math.max(ROUNDING * (model?.size ?? 0), 1e-3 * far)) return [];
    const sign = part > 0 ? '+' : '';
    return [`${'xyz'[axis]} ${sign}${number(part * factor)}`];
  });
  return parts.length > 0 ? `${parts.join('  ')} ${unit}`.trim() : `0 ${unit}`.trim();
}
