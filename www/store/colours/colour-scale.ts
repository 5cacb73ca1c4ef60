/**
 * The measure that colours the faces, the range of the colours, and the distribution of the values.
 * The measure is that of the scene's constraints, until the user chooses another.
 * The view chooses the range and counts the values (`src/view/appearance/value_spread.rs`).
 */

import { RENEW_MS, throttled } from '../../ui/dom.ts';
import type { Measure } from '../../solver/types.ts';
import { newestOnly } from '../latest-only.ts';
import { declared } from './measures.ts';
import { spreadOf } from './spread.ts';
import { AUTOMATIC, hasMoved, showsFitted, type State, type Store } from '../state.ts';
import type { SolverClient } from '../../solver/solver-client.ts';
import type { View } from '../../pkg/view-webgl2/shape_up.js';

/** No values yet. */
const NONE: Pick<State, 'spread' | 'range' | 'ownRange'> = {
  spread: null,
  range: [0, 0],
  ownRange: AUTOMATIC,
};

/** @param view null while nothing can draw */
export function colourFaces(store: Store, solver: SolverClient, view: () => View | null) {
  /** The measure that the document suggests; undefined before a document. */
  let suggested: Measure | null | undefined;

  store.subscribe(['document'], (state) => {
    const before = suggested;
    suggested = state.document ? state.document.measure : undefined;
    if (suggested !== undefined && suggested !== before && !state.measureChosen)
      store.set({ measure: suggested });
  });
  solver.on('model', () => store.set(NONE));
  const updateSoon = throttled(RENEW_MS, update);
  // The first values of a measure get their range at once.
  solver.on('frame', () => (store.get().spread ? updateSoon() : update()));
  store.subscribe(['measure', 'measures', 'display', 'halfway', 'fitted', 'model'], (state) => {
    const { display, halfway } = state;
    // Addresses, scenes and scripts may name a measure that does not exist.
    const measure = declared(state, state.measure)?.id ?? null;
    const projections = display.outlines || display.arrows || halfway;
    const shapes = showsFitted(state);
    solver.tell.show({ measure, shapes, projections, corners: display.bands });
  });
  store.subscribe(['measure'], () => store.set(NONE));
  store.subscribe(['document', 'tolerances', 'ownRange', 'display', 'renderer'], update);

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
    const { measure, numbers } = state;
    const about = declared(state, measure);
    const { geometry } = solver;
    const drawing = view();
    if (!about || !drawing || !geometry?.values || geometry.measure !== measure) return;
    const { values } = geometry;
    const moved = hasMoved(numbers);
    if (moved) void askForOriginal();
    if (moved && !original && !hasFailed) return;
    const before = original?.length === values.length ? original : null;
    const { range, spread } = spreadOf(drawing, state, about, values, before);
    if (range.some((end, i) => end !== state.range[i])) store.set({ range });
    store.set({ spread });
  }
}
