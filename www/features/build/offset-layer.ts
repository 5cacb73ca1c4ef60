/** The offset in the view, with failed beams and posts, and failed panels of the model, in red. */

import { FAILED } from '../../store/state.ts';
import type { OffsetLayer } from '../../pkg/engine/shape_up.js';
import type { AppContext } from '../../app/context.ts';

const NONE = new Uint32Array(0);

export function offsetLayer({ solver, actions, viewport }: AppContext) {
  let layer: OffsetLayer | null = null;
  /** The mesh of the layer. */
  let mesh: object | undefined;

  /** The layer, unless another mesh has been opened since. */
  const fitting = () => (solver.geometry?.connectivity === mesh ? layer : null);

  function draw() {
    const { points = new Float64Array(0), edges = NONE, vertices = NONE } = fitting() ?? {};
    viewport.unmeasured((view) => view.setLayer(points, edges, vertices));
  }

  /** Shows the offset of the mesh that is open. Without one, its points are empty. */
  function show(next: OffsetLayer | null) {
    layer = next;
    mesh = solver.geometry?.connectivity;
    draw();
    const faces = layer?.panels ?? NONE;
    const tint = faces.length > 0 ? { faces, vertices: NONE, colour: FAILED } : null;
    actions.tint('unbuildable', tint);
  }

  viewport.on('ready', draw);
  return { show };
}
