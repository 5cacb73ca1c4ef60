/**
 * Colours each constraint row on the elements it acts on, while no measure colours the faces. The
 * solver supplies the colours; they are valid until the next edit.
 */

import type { Store } from '../state.ts';
import type { SolverClient } from '../../solver/solver-client.ts';
import type { Actions } from '../actions.ts';

export function colourRows(store: Store, solver: SolverClient, actions: Actions) {
  /** Number of the latest request; older answers are discarded. */
  let newest = 0;
  /** Key of the rows whose colours are shown. */
  let shown = '';

  solver.on('model', () => {
    newest += 1;
    shown = '';
    store.set({ rowColours: null });
  });

  store.subscribe(['document', 'measure'], async ({ document, measure }) => {
    const rows = measure === null && document ? document.constraints : [];
    const key = JSON.stringify(rows);
    if (key === shown) return;
    shown = key;
    newest += 1;
    const mine = newest;
    const needed = rows.some(({ enabled }) => enabled);
    const rowColours = needed ? await actions.reportErrors(solver.ask.rowColours()) : null;
    if (mine === newest) store.set({ rowColours: rowColours ?? null });
  });
}
