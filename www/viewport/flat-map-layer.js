/** Display of the flat map beside the model. */

/** @typedef {import("../pkg/view-webgl2/shape_up.js").View} View */
/** @typedef {import("../store/view-modes.js").FlatMap} FlatMap */

/** Map of each view. @type {WeakMap<View, import("../solver/messages.js").Parametrization>} */
const shown = new WeakMap();

/**
 * @param {View} view
 * @param {{ flatMap: FlatMap | null }} state
 */
export function showFlatMap(view, { flatMap }) {
  if (!flatMap) {
    view.clearMap();
    shown.delete(view);
    return;
  }
  const { found, onModel, onMap, squares } = flatMap;
  if (shown.get(view) !== found) view.setMap(found.uv, found.flippedFaces);
  shown.set(view, found);
  const values = onMap === 'errors' ? found.faceErrors : undefined;
  view.setMapLooks(squares, onModel === 'checks', onMap === 'checks', values, 1, found.high);
}

/**
 * Returns the values that colour the model's faces while its map is shown, and their range.
 * @param {FlatMap} flatMap
 * @returns {[Float32Array | undefined, number, number]}
 */
export function modelErrors({ found, onModel }) {
  return [onModel === 'errors' ? found.faceErrors : undefined, 1, found.high];
}
