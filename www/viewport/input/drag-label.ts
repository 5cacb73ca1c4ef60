/** Label beside a dragged handle: its displacement, in the unit of the mesh. */

import { RENEW_MS, element, setText, throttled } from '../../ui/dom.ts';
import { displacement } from '../../ui/words.ts';
import type { Viewport } from '../viewport.ts';
import type { Store } from '../../store/state.ts';

export function showMoved(viewport: Viewport, store: Store) {
  const label = element('p', { id: 'moved', hidden: true });
  viewport.element.after(label);
  const write = () => {
    const { moved, document, model } = store.get();
    if (!moved) return;
    setText(
      label,
      displacement(Float64Array.from(moved.by), document?.units ?? '', model?.size ?? 0),
    );
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
