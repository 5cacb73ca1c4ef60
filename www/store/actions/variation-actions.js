/** What the page can do with other shapes that are as exact: it comes when somebody first asks. */

/** @typedef {import("../../solver/messages.js").VariationAsk} VariationAsk */
/** @typedef {import("../../solver/messages.js").VariationAnswers} VariationAnswers */

/**
 * @param {import("../../solver/solver-client.js").SolverClient} solver
 * @param {import("../actions.js").Actions} actions
 */
export function variationActions(solver, { reportErrors }) {
  /**
   * @template {VariationAsk} Ask
   * @param {Ask} ask
   * @returns {Promise<VariationAnswers[Ask["what"]]>}
   */
  const asked = async (ask) => {
    const answer = await solver.request({ type: 'variations', ask });
    return /** @type {VariationAnswers[Ask["what"]]} */ (answer);
  };
  return {
    /** Begins to look for the ways to change the shape; whether there can be any. */
    find: () => asked({ what: 'find' }),

    /** Goes on with that for a moment. */
    advance: () => asked({ what: 'advance' }),

    /** @param {number} index */
    way: (index) => asked({ what: 'way', index }),

    /** Shows the way at once. @param {Float64Array} coefficients */
    show: (coefficients) => asked({ what: 'show', coefficients }),

    /** Goes there and becomes exact again. @param {Float64Array} coefficients */
    reach: (coefficients) => asked({ what: 'reach', coefficients }),

    /** Makes what was reached the design. */
    keep: () => reportErrors(asked({ what: 'keep' })),

    /** Goes back to the shape that was varied. */
    leave: () => reportErrors(asked({ what: 'leave' })),

    /** The numbers of the shapes that were kept. @param {number} tolerance */
    table: (tolerance) => asked({ what: 'table', tolerance }),

    /** The positions of one of them. @param {number} index */
    positions: (index) => asked({ what: 'positions', index }),
  };
}
