/** Display of two pictures, left and right of a divider. */

import type { View } from '../pkg/view-webgl2/shape_up.js';
import type { Split } from '../store/view-modes.ts';

/** The split that each view shows. */
const shown: WeakMap<View, Split> = new WeakMap();

export function showSplit(view: View, { split }: { split: Split | null }) {
  const before = shown.get(view);
  if (!split) {
    if (shown.delete(view)) view.clearSplit();
    return;
  }
  shown.set(view, split);
  if (before?.at !== split.at) view.setSplit(split.at);
  split.sides.forEach((side, i) => {
    if (side === before?.sides[i]) return;
    const { positions, values, corners, low, top, tolerance } = side;
    view.setSplitSide(i, positions, values, corners, low, top, tolerance ?? undefined);
  });
}
