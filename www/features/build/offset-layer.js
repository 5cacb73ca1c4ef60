/** The offset in the view, with failed beams and posts, and failed panels of the model, in red. */

const NONE = new Uint32Array(0);
/** The colour of panels that exceed a limit. @type {[number, number, number]} */
const FAILED = [214, 40, 57];

/** @typedef {import("../../solver/messages.js").OffsetLayer} OffsetLayer */

/** @param {import("../../app/context.js").AppContext} app */
export function offsetLayer({ store, actions, viewport }) {
  /** @type {OffsetLayer | null} */
  let layer = null;
  /** The tint of its failed panels. @type {import("../../store/state.js").Tint | null} */
  let tint = null;

  /** The model of that tint. @type {import("../../store/state.js").State["model"]} */
  let tinted = null;

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

  /** @param {OffsetLayer | null} next */
  function show(next) {
    layer = next;
    draw();
    const before = tint;
    const failed = fits() ? (layer?.panels ?? NONE) : NONE;
    tint = failed.length > 0 ? { faces: failed, vertices: NONE, colour: FAILED } : null;
    const { tint: shown, model } = store.get();
    tinted = model;
    if (shown === before || shown === null) actions.tint(tint);
  }

  viewport.on('ready', draw);
  // Restores the tint after a temporary one, such as an element pointed at.
  store.subscribe(['tint'], (now) => {
    // The tint of another mesh is out of date.
    if (now.model !== tinted) tint = null;
    if (tint && !now.tint) actions.tint(tint);
  });
  return { show };
}
