/**
 * The flat map beside the model: what the page knows of it while it is shown, and how the view shows
 * it. How it is made, and its panel, come with `uv-controller.js` when it is first asked for.
 */

import { messageOf } from '../../solver/messages.js';

/** @typedef {import("../../pkg/view-webgl2/shape_up.js").View} View */

/**
 * What a surface shows: the squares of the map, or the colours of the quasi-conformal error.
 * @typedef {"checks" | "errors"} Look
 */

/**
 * @typedef {object} FlatMap
 * @property {import("../../solver/messages.js").Parametrization} found
 * @property {import("../../solver/messages.js").MapWeights} weights that it was made with
 * @property {import("../../solver/messages.js").MapNorm} norm that it was made with
 * @property {number} iteration of the shape that was flattened
 * @property {Look} onModel
 * @property {Look} onMap
 * @property {number} squares along the longer side of the map
 */

/** The map that each view has. @type {WeakMap<View, import("../../solver/messages.js").Parametrization>} */
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
 * What the faces of the model are coloured by while its map is shown: values, from, to.
 * @param {FlatMap} flatMap
 * @returns {[Float32Array | undefined, number, number]}
 */
export function modelErrors({ found, onModel }) {
  return [onModel === 'errors' ? found.faceErrors : undefined, 1, found.high];
}

/**
 * Shows the map of the model that is open, or takes it away.
 * @param {import("./uv-controller.js").Parts} parts
 */
export async function toggleFlatMap(parts) {
  try {
    const { Parametrize } = await import('./uv-controller.js');
    await Parametrize.of(parts).toggle();
  } catch (error) {
    parts.alerts.error(messageOf(error));
  }
}
