/** The offset in the view, with failed beams and posts, and failed panels of the model, in red. */

import type { OffsetLayer } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';
import type { State, Tint } from '../../store/state.ts';

const NONE = new Uint32Array(0);
/** The colour of panels that exceed a limit. */
const FAILED: [number, number, number] = [214, 40, 57];

export function offsetLayer({ store, actions, viewport }: AppContext) {
  let layer: OffsetLayer | null = null;
  /** The tint of its failed panels. */
  let tint: Tint | null = null;

  /** The model of that tint. */
  let tinted: State['model'] = null;

  /** Whether the layer is of the current mesh; another one may have been opened since. */
  const fits = () => layer?.points.length === 3 * (store.get().model?.vertices ?? 0);

  function draw() {
    const { points = new Float64Array(0), edges = NONE, vertices = NONE } = layer ?? {};
    viewport.unmeasured((view) =>
      fits()
        ? view.setLayer(points, edges, vertices)
        : view.setLayer(new Float64Array(0), NONE, NONE),
    );
  }

  function show(next: OffsetLayer | null) {
    layer = next;
    draw();
    const before = tint;
    const failed = fits() ? (layer?.panels ?? NONE) : NONE;
    tint = failed.length > 0 ? { faces: failed, vertices: NONE, colour: FAILED } : null;
    const { tint: shown, model } = store.get();
    tinted = model;
    // What cannot be built is seen before vertices that stand still, whose tint has no faces.
    const isFree = shown?.faces.length === 0;
    if (shown === before || shown === null || (tint && isFree)) actions.look({ tint });
  }

  viewport.on('ready', draw);
  // Restores the tint after that of something else.
  store.subscribe(['tint'], (now) => {
    // The tint of another mesh is out of date.
    if (now.model !== tinted) tint = null;
    if (tint && !now.tint) actions.look({ tint });
  });
  return { show };
}
