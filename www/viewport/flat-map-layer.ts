/** Display of the flat map beside the model. */

import type { View } from '../pkg/view-webgl2/shape_up.js';
import type { FlatMap } from '../store/state.ts';
import type { Parametrization } from '../solver/types.ts';

/** Map of each view. */
const shown: WeakMap<View, Parametrization> = new WeakMap();

export function showFlatMap(view: View, { flatMap }: { flatMap: FlatMap | null }) {
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

/** Returns the values that colour the model's faces while its map is shown, and their range. */
export function modelErrors({
  found,
  onModel,
}: FlatMap): [Float32Array | undefined, number, number] {
  return [onModel === 'errors' ? found.faceErrors : undefined, 1, found.high];
}
