/** Camera and display settings that are saved with a model. */

/**
 * The saved parts of the state under their names there, and `plot`, the tab of the analysis.
 * @typedef {{ [part in typeof PARTS[number]]: import("../store/state.js").State[part] } & { plot: string }} SavedView
 */

/**
 * @typedef {object} ViewContext
 * @property {import("../store/state.js").Store} store
 * @property {import("../store/actions.js").Actions} actions
 * @property {{ show: (tab: string) => void, shown: () => string }} analysis plots and tables
 */

/** @type {["camera", "parallel", "views", "tab", "measure", "measureChosen", "tolerance", "tolerances"]} */
const PARTS = [
  'camera',
  'parallel',
  'views',
  'tab',
  'measure',
  'measureChosen',
  'tolerance',
  'tolerances',
];

/** @param {ViewContext} parts @returns {SavedView} */
export function viewOf({ store, analysis }) {
  const state = store.get();
  const parts = Object.fromEntries(PARTS.map((part) => [part, state[part]]));
  return /** @type {SavedView} */ ({ ...parts, plot: analysis.shown() });
}

/**
 * Restores the saved view of a model that was just opened.
 * @param {SavedView | null} view null if none was saved
 * @param {ViewContext} parts
 */
export function restoreView(view, { store, actions, analysis }) {
  if (!view) return;
  const { plot, ...parts } = view;
  const known = store.get().measures.some(({ id }) => id === parts.measure);
  if (!known) parts.measure = store.get().measure;
  actions.look(parts);
  analysis.show(plot);
}
