/** The offset in the view, with failed beams and posts, and failed panels of the model, in red. */

import type { OffsetLayer } from '../../pkg/engine/shape_up.js';
import type { AppContext } from '../../app/context.ts';

const NONE = new Uint32Array(0);
/** The colour of panels that exceed a limit. */
const FAILED: [number, number, number] = [214, 40, 57];

export function offsetLayer({ store, actions, viewport }: AppContext) {
  let layer: OffsetLayer | null = null;

  /** The layer, if it is of the current mesh; another one may have been opened since. */
  const fitting = () =>
    layer?.points.length === 3 * (store.get().model?.vertices ?? 0) ? layer : null;

  function draw() {
    const { points = new Float64Array(0), edges = NONE, vertices = NONE } = fitting() ?? {};
    viewport.unmeasured((view) => view.setLayer(points, edges, vertices));
  }

  function show(next: OffsetLayer | null) {
    layer = next;
    draw();
    const { panels: faces = NONE } = fitting() ?? {};
    const tint = faces.length > 0 ? { faces, vertices: NONE, colour: FAILED } : null;
    actions.tint('unbuildable', tint);
  }

  viewport.on('ready', draw);
  return { show };
}
