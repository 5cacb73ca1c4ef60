/**
 * What the faces are coloured by, between which values, and how the values are spread. The measure
 * is that of what the scene asks for, until somebody chooses another. The range stays while a run
 * goes on, so that colours mean the same from picture to picture; it grows when a drag makes things
 * worse, and starts anew with another mesh or measure, or when it is asked to.
 */

import { RENEW_MS, throttled } from './dom.js';
import { messageOf } from './messages.js';
import { declared, measureOfScene, roundingOf } from './measures.js';
import { spreadOf } from './spread.js';

/** A range finer than so many times the rounding would colour what nobody could build or see. */
const LEAST_RANGE = 1000;

/**
 * @param {import("./state.js").Store} store
 * @param {import("./solver-client.js").SolverClient} solver
 * @returns {{ refit: () => void }} takes the range of the colours from the shape as it is
 */
export function colourFaces(store, solver) {
  let fresh = true;

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
    fresh = true;
    store.set({ spread: null });
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
    store.set({ spread: null, tolerance: null });
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
      takeIn();
    } catch (error) {
      // The bars say what matters; the outline only compares.
      console.warn(messageOf(error));
    }
  }

  /** Takes in the values of the newest frame. */
  function takeIn() {
    const { measure, size, range, tolerance, spread } = store.get();
    const about = declared(store.get(), measure);
    const { geometry } = solver;
    if (!about || !geometry?.values || geometry.measure !== measure) return;
    const least = LEAST_RANGE * roundingOf(about, size);
    const now = spreadOf(
      about.id,
      geometry.values,
      least,
      fresh ? 0 : range[1],
      tolerance,
      original?.length === geometry.values.length ? original : null,
    );
    askForOriginal();
    if (fresh || now.greatest > range[1]) {
      store.set({ range: [fresh ? 0 : range[0], Math.max(now.greatest, least)] });
    }
    fresh = false;
    if (JSON.stringify(now) !== JSON.stringify(spread)) store.set({ spread: now });
  }

  return {
    refit: () => {
      fresh = true;
      takeIn();
    },
  };
}
