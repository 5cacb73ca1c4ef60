/** Actions on the hardness of constraints. Loaded on first use. */

/** @typedef {import("../../solver/messages.js").Require} Require */

/**
 * @param {import("../../solver/solver-client.js").SolverClient} solver
 * @param {import("../actions.js").Actions} actions
 */
export const exactActions = (solver, { reportErrors }) => ({
  /**
   * Sets the hardness of a row and runs, as one step of undo.
   * @param {number} index
   * @param {Require} require
   */
  require: (index, require) =>
    reportErrors(
      solver.request({ type: 'editAndRun', edit: { type: 'setConstraint', index, require } }),
    ),

  /** Returns the cost of meeting constraints exactly instead of within a distance. */
  offer: () => solver.request({ type: 'exactOffer' }),

  /** Searches for an equally exact shape of lower energy; returns how far it came. */
  improve: () => solver.request({ type: 'improvement' }),

  /** Ends the search and keeps its result. */
  endTrial: () => solver.request({ type: 'endTrial' }),

  /** Applies the last offer. @param {boolean} joins merges it into the last step of undo */
  accept: (joins) => reportErrors(solver.request({ type: 'makeExact', joins })),
});
