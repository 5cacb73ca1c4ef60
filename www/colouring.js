/**
 * What the faces are coloured by, between which values, and how the values are spread. The measure
 * is that of what the scene asks for, until somebody chooses another. The range stays while a run
 * goes on, so that colours mean the same from picture to picture; it grows when a drag makes things
 * worse, and starts anew with another mesh or measure, or when it is asked to. Of what opens solved it
 * is that of the original, as if the run had been seen.
 */

import { RENEW_MS, throttled } from './dom.js';
import { messageOf } from './messages.js';
import { declared, measureOfScene, roundingOf } from './measures.js';
import { greatestOf, spreadOf } from './spread.js';

/** A range finer than so many times the rounding would colour what nobody could build or see. */
const LEAST_RANGE = 1000;

/** Until there are values. @type {Pick<import("./state.js").State, "spread" | "range">} */
const NONE = { spread: null, range: [0, 0] };

/**
 * @param {import("./state.js").Store} store
 * @param {import("./solver-client.js").SolverClient} solver
 * @returns {{ refit: () => void }} takes the range of the colours from the shape as it is
 */
export function colourFaces(store, solver) {
  let fresh = true;
  /** The model that is open has not been coloured yet. */
  let isNew = true;

  /** Rows of constraints; none before the document of a model is there. @type {number | undefined} */
  let rows;

  store.subscribe(['document'], (state) => {
    const before = rows;
    rows = state.document?.constraints.length;
    const opened = before === undefined && rows !== undefined;
    const firstRow = before === 0 && rows && !state.measureChosen;
    if (opened || firstRow) store.set({ measure: measureOfScene(state) });
  });
  solver.addEventListener('model', () => {
    fresh = isNew = true;
    store.set(NONE);
  });
  const takeInSoon = throttled(RENEW_MS, takeIn);
  // What is coloured for the first time has its range at once.
  solver.addEventListener('frame', () => (fresh ? takeIn() : takeInSoon()));
  store.subscribe(['measure', 'display', 'halfway'], ({ measure, display, halfway }) => {
    const projections = display.outlines || display.arrows || halfway;
    const { shapes, bands } = display;
    solver.tell({ type: 'show', measure, shapes, projections, corners: bands });
  });
  store.subscribe(['measure'], () => {
    fresh = true;
    store.set({ ...NONE, tolerance: null });
  });
  store.subscribe(['tolerance', 'range'], takeIn);

  /** Values of the original; null while they are not known. @type {Float32Array | null} */
  let original = null;
  let isAsked = false;
  const forget = () => {
    original = null;
    isAsked = false;
  };
  // An edit may ask for something else of the faces.
  store.subscribe(['measure', 'document'], forget);

  /** Asks for the values of the original, once something has moved. */
  async function askForOriginal() {
    const { measure, numbers } = store.get();
    if (isAsked || !measure || !numbers?.iteration) return;
    isAsked = true;
    try {
      const values = await solver.request({ type: 'faceValues', measure, original: true });
      if (store.get().measure !== measure) return;
      original = values;
    } catch (error) {
      // The bars say what matters; the outline only compares.
      console.warn(messageOf(error));
      isNew = false;
    }
    takeIn();
  }

  /** Takes in the values of the newest frame. */
  function takeIn() {
    const { measure, size, range, tolerance, spread, numbers } = store.get();
    const about = declared(store.get(), measure);
    const { geometry } = solver;
    if (!about || !geometry?.values || geometry.measure !== measure) return;
    askForOriginal();
    if (isNew && numbers?.iteration && !original) return;
    const before = original?.length === geometry.values.length ? original : null;
    const now = spreadOf(
      about.id,
      geometry.values,
      LEAST_RANGE * roundingOf(about, size),
      !fresh ? range[1] : isNew && before ? greatestOf(before) : 0,
      tolerance,
      before,
    );
    if (fresh || now.greatest > range[1]) {
      store.set({ range: [fresh ? 0 : range[0], now.top] });
    }
    fresh = isNew = false;
    if (JSON.stringify(now) !== JSON.stringify(spread)) store.set({ spread: now });
  }

  return {
    refit: () => {
      fresh = true;
      takeIn();
    },
  };
}
