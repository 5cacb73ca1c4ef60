/**
 * What the faces are coloured by, and between which values. The range stays while a run goes on, so
 * that colours mean the same from picture to picture; it grows when a drag makes things worse, and
 * starts anew with another mesh or measure, or when it is asked to.
 */

/**
 * @param {import("./state.js").Store} store
 * @param {import("./solver-client.js").SolverClient} solver
 * @returns {{ refit: () => void }} takes the range of the colours from the shape as it is
 */
export function colourFaces(store, solver) {
  let fresh = true;
  /** The largest value of the newest frame. */
  let greatest = 0;

  solver.addEventListener('model', () => (fresh = true));
  solver.addEventListener('frame', (event) => {
    const { detail } = /** @type {CustomEvent} */ (event);
    if (!detail.values || detail.measure !== store.get().measure) return;
    greatest = detail.values.reduce(larger, 0);
    const [, top] = store.get().range;
    if (fresh || greatest > top) store.set({ range: [0, greatest] });
    fresh = false;
  });
  store.subscribe(['measure', 'display'], ({ measure, display }) => {
    solver.tell({ type: 'show', measure, shapes: display.shapes });
  });
  store.subscribe(['measure'], () => (fresh = true));
  return { refit: () => store.set({ range: [0, greatest] }) };
}

/**
 * @param {number} a
 * @param {number} b not a number where a face has no size
 */
function larger(a, b) {
  return b > a ? b : a;
}
