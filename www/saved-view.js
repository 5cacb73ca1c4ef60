/**
 * How a model is looked at, which is kept with it: where from, coloured by what, within which tolerance,
 * beside which plot or table.
 */

/**
 * @typedef {object} SavedView
 * @property {number[] | null} camera
 * @property {boolean} parallel
 * @property {import("./messages.js").Measure | null} measure that somebody chose
 * @property {number | null} tolerance
 * @property {string} tab of the analysis
 * @property {import("./state.js").State["tab"]} panel that is shown where there is room for one
 */

/**
 * @typedef {object} Seen
 * @property {import("./state.js").Store} store
 * @property {ReturnType<typeof import("./analysis.js").analysisRegion>} analysis
 */

/** @param {Seen} parts @returns {SavedView} */
export function viewOf({ store, analysis }) {
  const { camera, parallel, measure, measureChosen, tolerance, tab: panel } = store.get();
  return {
    camera,
    parallel,
    measure: measureChosen ? measure : null,
    tolerance,
    tab: analysis.shown(),
    panel,
  };
}

/**
 * Looks at the model that was just opened as it was looked at when it was kept.
 * @param {SavedView | null} view
 * @param {Seen} parts
 */
export async function lookAgain(view, { store, analysis }) {
  if (!view) return;
  const { camera, parallel, measure, tolerance, tab, panel } = view;
  const { measures } = store.get();
  store.set({ parallel, tab: panel });
  if (measures.some(({ id }) => id === measure)) store.set({ measure, measureChosen: true });
  analysis.show(tab);
  if (camera) store.set({ camera });
  // Another measure begins without one.
  await Promise.resolve();
  store.set({ tolerance });
}
