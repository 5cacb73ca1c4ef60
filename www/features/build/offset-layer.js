/** The offset in the view, and in red what is not within a limit: beams and posts there, panels on the model. */

const NONE = new Uint32Array(0);
/** The colour of panels that fail. @type {[number, number, number]} */
const FAILED = [214, 40, 57];

/** @typedef {import("../../solver/messages.js").OffsetLayer} OffsetLayer */

/** @param {import("../../app/context.js").AppContext} app */
export function offsetLayer({ store, actions, viewport }) {
  /** @type {OffsetLayer | null} */
  let layer = null;
  /** What of it is tinted. @type {import("../../store/state.js").Tint | null} */
  let tint = null;

  /** The mesh that it belongs to. @type {import("../../store/state.js").State["model"]} */
  let tinted = null;

  function draw() {
    const { points = new Float64Array(0), edges = NONE, vertices = NONE } = layer ?? {};
    // Another mesh may have come since.
    const { model } = store.get();
    const fits = points.length === 3 * (model?.vertices ?? 0);
    viewport.unmeasured((view) =>
      fits
        ? view.setLayer(points, edges, vertices)
        : view.setLayer(new Float64Array(0), NONE, NONE),
    );
  }

  /** @param {OffsetLayer | null} next */
  function show(next) {
    layer = next;
    draw();
    const before = tint;
    tint = layer?.panels.length ? { faces: layer.panels, vertices: NONE, colour: FAILED } : null;
    const { tint: shown, model } = store.get();
    tinted = model;
    if (shown === before || shown === null) actions.tint(tint);
  }

  viewport.on('ready', draw);
  // Whoever points at something tints that, and nothing afterwards.
  store.subscribe(['tint'], (now) => {
    // Of another mesh nothing is known yet.
    if (now.model !== tinted) tint = null;
    if (tint && !now.tint) actions.tint(tint);
  });
  return { show };
}
