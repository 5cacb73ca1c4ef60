/**
 * Colours each constraint row on the elements it acts on, while no measure colours the faces. The
 * solver supplies the colours; they are valid until the next edit.
 */

import { newestOnly } from '../latest-only.ts';
import type { Store } from '../state.ts';
import type { SolverClient } from '../../solver/solver-client.ts';
import type { Actions } from '../actions.ts';

export function colourRows(store: Store, solver: SolverClient, actions: Actions) {
  const newest = newestOnly(() => store.get().model);

  solver.on('model', () => store.set({ rowColours: null }));

  // With every document: a set of the same name may have other members, of which a row says nothing.
  store.subscribe(['document', 'measure'], async ({ document, measure }) => {
    const needed = measure === null && document?.constraints.some(({ enabled }) => enabled);
    const asked = needed ? solver.ask.rowColours() : null;
    // Null if refused, with an alert.
    const rowColours = await newest(actions.reportErrors(asked).then((found) => found ?? null));
    if (rowColours !== undefined) store.set({ rowColours });
  });
}
