/**
 * The measure that colours the faces, the range of the colours, and the distribution of the values.
 * The measure is that of the scene's constraints, until the user chooses another.
 *
 * The range does not depend on the history: it begins at the tolerance (or at 0 if all values are
 * coloured) and ends at a round number that neither the worst face of the original nor the current
 * worst face exceeds. It is therefore constant during a run that improves the shape, and colours
 * are comparable between pictures. The user can set either end instead.
 */

import { RENEW_MS, throttled } from '../../ui/dom.ts';
import type { Measure } from '../../solver/types.ts';
import { newestOnly } from '../newest-only.ts';
import { declared, measureOfScene, roundingOf, toleranceOf } from './measures.ts';
import { greatestOf, spreadOf } from '../../ui/plot/histogram.ts';
import { axisOf, roundUp } from '../../ui/plot/value-axis.ts';
import type { OwnRange, State, Store } from '../state.ts';
import type { SolverClient } from '../../solver/solver-client.ts';

/** Smallest range in multiples of the rounding error; nothing finer can be seen or built. */
const LEAST_RANGE = 1000;
/** Beginning of a logarithmic range over all values, relative to its end. */
const LOG_RANGE = 1e-4;
/** On a logarithmic axis, values within the tolerance get the width of this factor. */
const LOG_WITHIN = 0.1;

/** Both ends and the end of the axis are automatic. */
const AUTOMATIC: OwnRange = { low: null, high: null, top: null };

/** No values yet. */
const NONE: Pick<State, 'spread' | 'range' | 'ownRange'> = {
  spread: null,
  range: [0, 0],
  ownRange: AUTOMATIC,
};

/** @returns sets the end of the range to the worst face of the current shape */
export function colourFaces(store: Store, solver: SolverClient): { fit: () => void } {
  /** The measure that the document suggests; undefined before a document. */
  let suggested: Measure | null | undefined;

  store.subscribe(['document'], (state) => {
    const before = suggested;
    suggested = state.document ? measureOfScene(state) : undefined;
    if (suggested !== undefined && suggested !== before && !state.measureChosen)
      store.set({ measure: suggested });
  });
  solver.on('model', () => store.set(NONE));
  const updateSoon = throttled(RENEW_MS, update);
  // The first values of a measure get their range at once.
  solver.on('frame', () => (store.get().spread ? updateSoon() : update()));
  store.subscribe(['measure', 'measures', 'display', 'halfway'], (state) => {
    const { display, halfway } = state;
    // Addresses, scenes and scripts may name a measure that does not exist.
    const measure = declared(state, state.measure)?.id ?? null;
    const projections = display.outlines || display.arrows || halfway;
    const { shapes, bands } = display;
    solver.tell.show({ measure, shapes, projections, corners: bands });
  });
  store.subscribe(['measure'], () => store.set(NONE));
  store.subscribe(['tolerance', 'tolerances', 'ownRange', 'display'], update);

  /** Values of the original; null if unknown. */
  let original: Float32Array | null = null;
  const newest = newestOnly(
    () => store.get().measure,
    () => store.get().document,
  );
  let isAsked = false;
  /** Whether the request failed: the range depends on the current values only. */
  let hasFailed = false;
  const forget = () => {
    original = null;
    isAsked = hasFailed = false;
  };
  // An edit may change what the measure requires of the faces.
  store.subscribe(['measure', 'document'], forget);

  /** Requests the values of the original, once the shape has changed. */
  async function askForOriginal() {
    const { measure } = store.get();
    if (isAsked || !measure) return;
    isAsked = true;
    try {
      const values = await newest(solver.ask.originalValues(measure));
      if (!values) return;
      original = values;
    } catch {
      // Not worth an alert: the bars show the current values, the outline is only a comparison; and
      // a solver that has stopped reports that itself.
      hasFailed = true;
    }
    update();
  }

  /** Evaluates the values of the latest frame. */
  function update() {
    const state = store.get();
    const { measure, size, spread, numbers, ownRange, range } = state;
    const about = declared(state, measure);
    const { geometry } = solver;
    if (!about || !geometry?.values || geometry.measure !== measure) return;
    const { values } = geometry;
    if (numbers?.iteration) void askForOriginal();
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
    // For signed values, 0 is the middle of the range.
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
