/** Camera and display settings that are saved with a model. */

import type { State, Store } from '../store/state.ts';
import type { Actions } from '../store/actions.ts';

const PARTS = [
  ...(['camera', 'parallel', 'views', 'tab', 'plot'] as const),
  ...(['measure', 'measureChosen', 'tolerances'] as const),
];

/** The saved parts of the state under their names there. */
export type SavedView = Pick<State, (typeof PARTS)[number]>;

export const viewOf = (state: Readonly<State>) =>
  Object.fromEntries(PARTS.map((part) => [part, state[part]])) as unknown as SavedView;

/** Restores the saved view of a model that was just opened. */
export function restoreView(view: SavedView, store: Store, actions: Actions) {
  const { measures, measure } = store.get();
  const known = measures.some(({ id }) => id === view.measure);
  actions.look(known ? view : { ...view, measure });
}
