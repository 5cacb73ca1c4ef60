/** Display of two pictures, left and right of a divider. */

/** @typedef {import("../pkg/view-webgl2/shape_up.js").View} View */
/** @typedef {import("../store/view-modes.js").Split} Split */

/** The split that each view shows. @type {WeakMap<View, Split>} */
const shown = new WeakMap();

/**
 * @param {View} view
 * @param {{ split: Split | null }} state
 */
export function showSplit(view, { split }) {
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
