/** The fitted shapes, shown although the user has not asked for them. */

import type { Actions } from './actions.ts';
import type { Store } from './state.ts';

/** Hides them with the next mesh. */
export function hideWithNextModel({
  store,
  actions,
}: {
  store: Store;
  actions: Pick<Actions, 'display'>;
}) {
  const { model } = store.get();
  const stop = store.subscribe(['model'], (now) => {
    if (now.model === model) return;
    stop();
    actions.display({ shapes: false });
  });
}
