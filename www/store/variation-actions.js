/** What the page can do with other shapes that are as exact: it comes when somebody first asks. */

/**
 * @param {import("../solver/solver-client.js").SolverClient} solver
 * @param {import("./actions.js").Actions} actions
 */
export const variationActions = (solver, { reportErrors }) => ({
  /** Begins to look for the ways to change the shape; whether there can be any. */
  find: () => solver.request({ type: 'findVariations' }),

  /** Goes on with that for a moment. */
  advance: () => solver.request({ type: 'advanceVariations' }),

  /** @param {number} index */
  way: (index) => solver.request({ type: 'variation', index }),

  /** Shows the way at once. @param {Float64Array} coefficients */
  show: (coefficients) => solver.request({ type: 'showVariation', coefficients }),

  /** Goes there and becomes exact again. @param {Float64Array} coefficients */
  reach: (coefficients) => solver.request({ type: 'reachVariation', coefficients }),

  /** Makes what was reached the design. */
  keep: () => reportErrors(solver.request({ type: 'keepVariation' })),

  /** Goes back to the shape that was varied. */
  leave: () => reportErrors(solver.request({ type: 'leaveVariation' })),

  /** The numbers of the shapes that were kept. @param {number} tolerance */
  table: (tolerance) => solver.request({ type: 'variantTable', tolerance }),

  /** The positions of one of them. @param {number} index */
  positions: (index) => solver.request({ type: 'variantPositions', index }),
});
