/**
 * What the faces are coloured by, between which values, and how the values are spread. The measure
 * is that of what the scene asks for, until somebody chooses another.
 *
 * The range of the colours follows from what there is and not from what there was: it begins at the
 * tolerance, or at 0 where all values have colours, and ends at a round number that the worst face of
 * the original does not exceed, nor the worst one now. So it stays while a run makes things better, and
 * colours mean the same from picture to picture. Either end can be chosen instead.
 */

import { RENEW_MS, throttled } from '../../ui/dom.js';
import { messageOf } from '../../solver/messages.js';
import { declared, measureOfScene, roundingOf, toleranceOf } from './measures.js';
import { greatestOf, spreadOf } from '../../ui/plot/histogram.js';
import { axisOf, roundUp } from '../../ui/plot/value-axis.js';

/** A range finer than so many times the rounding would colour what nobody could build or see. */
const LEAST_RANGE = 1000;
/** A logarithmic range over all values begins so far below its end. */
const LOG_RANGE = 1e-4;
/** On a logarithmic axis, what is within the tolerance has the room of this factor. */
const LOG_WITHIN = 0.1;

/** Both ends and the end of the axis follow from the values. @type {import("../state.js").OwnRange} */
const AUTOMATIC = { low: null, high: null, top: null };

/** Until there are values. @type {Pick<import("../state.js").State, "spread" | "range" | "ownRange">} */
const NONE = { spread: null, range: [0, 0], ownRange: AUTOMATIC };

/**
 * @param {import("../state.js").Store} store
 * @param {import("../../solver/solver-client.js").SolverClient} solver
 * @returns {{ fit: () => void }} ends the range of the colours at the worst face of the shape as it is
 */
export function colourFaces(store, solver) {
  /** Rows of constraints; none before the document of a model is there. @type {number | undefined} */
  let rows;

  store.subscribe(['document'], (state) => {
    const before = rows;
    rows = state.document?.constraints.length;
    const opened = before === undefined && rows !== undefined;
    const firstRow = before === 0 && rows;
    if ((opened || firstRow) && !state.measureChosen) store.set({ measure: measureOfScene(state) });
  });
  solver.on('model', () => store.set(NONE));
  const takeInSoon = throttled(RENEW_MS, takeIn);
  // What is coloured for the first time has its range at once.
  solver.on('frame', () => (store.get().spread ? takeInSoon() : takeIn()));
  store.subscribe(['measure', 'display', 'halfway'], ({ measure, display, halfway }) => {
    const projections = display.outlines || display.arrows || halfway;
    const { shapes, bands } = display;
    solver.send({ type: 'show', measure, shapes, projections, corners: bands });
  });
  store.subscribe(['measure'], () => store.set(NONE));
  store.subscribe(['tolerance', 'tolerances', 'ownRange', 'display'], takeIn);

  /** Values of the original; null while they are not known. @type {Float32Array | null} */
  let original = null;
  let isAsked = false;
  /** They are not to be had: the range is that of the values that there are. */
  let hasFailed = false;
  const forget = () => {
    original = null;
    isAsked = hasFailed = false;
  };
  // An edit may ask for something else of the faces.
  store.subscribe(['measure', 'document'], forget);

  /** Asks for the values of the original, once something has moved. */
  async function askForOriginal() {
    const { measure } = store.get();
    if (isAsked || !measure) return;
    isAsked = true;
    try {
      const values = await solver.request({ type: 'faceValues', measure, original: true });
      if (store.get().measure !== measure) return;
      original = values;
    } catch (error) {
      // The bars say what matters; the outline only compares.
      console.warn(messageOf(error));
      hasFailed = true;
    }
    takeIn();
  }

  /** Takes in the values of the newest frame. */
  function takeIn() {
    const state = store.get();
    const { measure, size, spread, numbers, ownRange, range } = state;
    const about = declared(state, measure);
    const { geometry } = solver;
    if (!about || !geometry?.values || geometry.measure !== measure) return;
    const { values } = geometry;
    if (numbers?.iteration) askForOriginal();
    if (numbers?.iteration && !original && !hasFailed) return;
    const before = original?.length === values.length ? original : null;

    const tolerance = toleranceOf(state, about);
    const { signed } = about;
    const { full } = state.display;
    const log = state.display.log && !signed;
    const greatest = greatestOf(values);
    const worst = Math.max(greatest, before ? greatestOf(before) : 0, 2 * (tolerance ?? 0));
    const top = roundUp(Math.max(worst, LEAST_RANGE * roundingOf(about, size)));
    const high = ownRange.high ?? top;
    const isPart = tolerance !== null && !full;
    const first = isPart && tolerance > 0 ? tolerance : log ? LOG_RANGE * high : 0;
    // Nothing is in the middle of values of both signs.
    const low = signed ? -high : Math.min(ownRange.low ?? first, high);
    const end = Math.max(ownRange.top ?? top, high, greatest);
    const least = signed ? -end : 0;
    const begin = log ? Math.min(low, tolerance ? LOG_WITHIN * tolerance : low) : least;
    const axis = axisOf(begin, end, log);
    const now = spreadOf(about.id, values, axis, tolerance, before);
    if (low !== range[0] || high !== range[1]) store.set({ range: [low, high] });
    if (JSON.stringify(now) !== JSON.stringify(spread)) store.set({ spread: now });
  }

  return {
    fit: () => {
      const { spread, range } = store.get();
      if (!spread || spread.greatest <= range[0]) return store.set({ ownRange: AUTOMATIC });
      const { greatest } = spread;
      store.set({ ownRange: { low: null, high: greatest, top: greatest } });
    },
  };
}
