/** Camera and display settings that are saved with a model. */

import type { State, Store } from '../store/state.ts';
import type { Actions } from '../store/actions.ts';

/** The saved parts of the state under their names there, and `plot`, the tab of the analysis. */
export type SavedView = { [part in (typeof PARTS)[number]]: State[part] } & { plot: string };

export interface ViewContext {
  store: Store;
  actions: Actions;
  /** plots and tables */
  analysis: { show: (tab: string) => void; shown: () => string };
}

const PARTS: [
  'camera',
  'parallel',
  'views',
  'tab',
  'measure',
  'measureChosen',
  'tolerance',
  'tolerances',
] = ['camera', 'parallel', 'views', 'tab', 'measure', 'measureChosen', 'tolerance', 'tolerances'];

export function viewOf({ store, analysis }: ViewContext): SavedView {
  const state = store.get();
  const parts = Object.fromEntries(PARTS.map((part) => [part, state[part]]));
  return { ...parts, plot: analysis.shown() } as SavedView;
}

/**
 * Restores the saved view of a model that was just opened.
 * @param view null if none was saved
 */
export function restoreView(view: SavedView | null, { store, actions, analysis }: ViewContext) {
  if (!view) return;
  const { plot, ...parts } = view;
  const known = store.get().measures.some(({ id }) => id === parts.measure);
  if (!known) parts.measure = store.get().measure;
  actions.look(parts);
  analysis.show(plot);
}
