/**
 * Two pictures of the model in place of one, left and right of a divider: what the page knows of them,
 * and how the view shows them. Their controls come with `split-view.js` when they are first asked for.
 */

import { messageOf } from '../../solver/messages.js';

/** @typedef {import("../../pkg/view-webgl2/shape_up.js").View} View */

/**
 * What a side shows: the original or the current shape, coloured by a measure.
 * @typedef {{ measure: import("../../solver/messages.js").Measure, original: boolean }} Choice
 */

/**
 * @typedef {object} Shown what the view needs of a side
 * @property {Float64Array | undefined} positions of the original, where it is shown
 * @property {Float32Array | undefined} values of the faces
 * @property {Float32Array | undefined} corners values of the vertices whose greatest those are, for bands
 * @property {number} top of the range of the colours, which begins at 0
 */

/**
 * @typedef {object} Split
 * @property {number} at where the divider is, from 0 to 1
 * @property {[(Choice & Shown), (Choice & Shown)]} sides left and right; a side that changes is another object
 */

/** What each view shows. @type {WeakMap<View, Split>} */
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
    const { positions, values, corners, top } = side;
    view.setSplitSide(i, positions, values, corners, 0, top);
  });
}

/**
 * Shows two pictures with what was chosen last, or one again.
 * @param {import("../../app/analysis.js").Parts} parts
 */
export function toggleSplit(parts) {
  if (parts.store.get().split) parts.store.set({ split: null, status: 'One picture' });
  else splitInto(parts);
}

/**
 * Shows two pictures.
 * @param {import("../../app/analysis.js").Parts} parts
 * @param {[Choice, Choice]} [choices] left and right
 */
export async function splitInto(parts, choices) {
  try {
    const { SplitView } = await import('./split-view.js');
    await SplitView.of(parts).open(choices);
  } catch (error) {
    parts.alerts.error(messageOf(error));
  }
}
