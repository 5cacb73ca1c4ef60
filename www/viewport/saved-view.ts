/** Camera, measure and open tab, which are saved with a model. */

import type { State, Store } from '../store/state.ts';
import type { Actions } from '../store/actions.ts';

const PARTS = [
  ...(['camera', 'parallel', 'views', 'step', 'plot'] as const),
  ...(['measure', 'measureChosen', 'tolerances'] as const),
];

/** The saved parts of the state under their names there. */
export type SavedView = Pick<State, (typeof PARTS)[number]>;

export const viewOf = (state: Readonly<State>) =>
  Object.fromEntries(PARTS.map((part) => [part, state[part]])) as unknown as SavedView;

/** Restores the saved view of a model that was just opened. */
export function restoreView(view: SavedView, store: Store, actions: Actions) {
  const { measures, measure } = store.get();
  // The user may have chosen none.
  const isNone = view.measure === null && view.measureChosen;
  const hasMeasure = isNone || measures.some(({ id }) => id === view.measure);
  actions.look(hasMeasure ? view : { ...view, measure });
}
