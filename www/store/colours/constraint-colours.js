/**
 * The colours of the rows of constraints on what they act on, while the faces are coloured by
 * nothing else. The solver knows what acts where; the answer holds until the next edit.
 */

/**
 * @param {import("../state.js").Store} store
 * @param {import("../../solver/solver-client.js").SolverClient} solver
 * @param {import("../actions.js").Actions} actions
 */
export function colourRows(store, solver, actions) {
  /** Only the answer to the newest question counts. */
  let newest = 0;
  /** What the colours on the page are those of. */
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
    const rowColours = needed
      ? await actions.reportErrors(solver.request({ type: 'rowColours' }))
      : null;
    if (mine === newest) store.set({ rowColours: rowColours ?? null });
  });
}
