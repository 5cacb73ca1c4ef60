/** What the page can do with what is required of constraints: it comes when somebody first asks. */

/** @typedef {import("../../solver/messages.js").Require} Require */

/**
 * @param {import("../../solver/solver-client.js").SolverClient} solver
 * @param {import("../actions.js").Actions} actions
 */
export const exactActions = (solver, { reportErrors }) => ({
  /** Requires something of a row and runs, one step of undo together. @param {number} index @param {Require} require */
  require: (index, require) =>
    reportErrors(
      solver.request({ type: 'editAndRun', edit: { type: 'setConstraint', index, require } }),
    ),

  /** What it would cost to be exact instead of within a distance. */
  offer: () => solver.request({ type: 'exactOffer' }),

  /** Looks for a shape that is as exact and costs less; how far it came. */
  improve: () => solver.request({ type: 'improvement' }),

  /** Ends that where it is. */
  endTrial: () => solver.request({ type: 'endTrial' }),

  /** Takes the shape of the last offer. @param {boolean} joins as a part of the last step of undo */
  accept: (joins) => reportErrors(solver.request({ type: 'makeExact', joins })),
});
