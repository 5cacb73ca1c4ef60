/**
 * What the faces are coloured by, and between which values. The measure is that of what the scene
 * asks for, until somebody chooses another. The range stays while a run goes on, so that colours
 * mean the same from picture to picture; it grows when a drag makes things worse, and starts anew
 * with another mesh or measure, or when it is asked to.
 */

import { measureOfScene } from './measures.js';

/** A range finer than this part of the mesh would colour what nobody could build or see. */
const LEAST_RANGE = 1e-9;

/**
 * @param {import("./state.js").Store} store
 * @param {import("./solver-client.js").SolverClient} solver
 * @returns {{ refit: () => void }} takes the range of the colours from the shape as it is
 */
export function colourFaces(store, solver) {
  let fresh = true;
  /** The largest value of the newest frame. */
  let greatest = 0;

  /** Rows of constraints; none before the document of a model is there. @type {number | undefined} */
  let rows;

  store.subscribe(['document'], (state) => {
    const before = rows;
    rows = state.document?.constraints.length;
    const opened = before === undefined && rows !== undefined;
    const firstRow = before === 0 && rows && !state.measureChosen;
    if (opened || firstRow) store.set({ measure: measureOfScene(state) });
  });
  solver.addEventListener('model', () => (fresh = true));
  solver.addEventListener('frame', (event) => {
    const { detail } = /** @type {CustomEvent} */ (event);
    if (!detail.values || detail.measure !== store.get().measure) return;
    greatest = detail.values.reduce(larger, LEAST_RANGE * store.get().size);
    const [, top] = store.get().range;
    if (fresh || greatest > top) store.set({ range: [0, greatest] });
    fresh = false;
  });
  store.subscribe(['measure', 'display'], ({ measure, display }) => {
    const projections = display.outlines || display.arrows;
    solver.tell({ type: 'show', measure, shapes: display.shapes, projections });
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
