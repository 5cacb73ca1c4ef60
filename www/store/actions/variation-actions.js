/** Actions on variations: other shapes that are equally exact. Loaded on first use. */

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
    /** Begins the search for variations; returns whether there can be any. */
    find: () => asked({ what: 'find' }),

    /** Continues the search for a moment. */
    advance: () => asked({ what: 'advance' }),

    /** @param {number} index */
    displacement: (index) => asked({ what: 'displacement', index }),

    /** Shows the linear combination of variations at once. @param {Float64Array} coefficients */
    show: (coefficients) => asked({ what: 'show', coefficients }),

    /** Moves there and projects back onto the constraints. @param {Float64Array} coefficients */
    project: (coefficients) => asked({ what: 'project', coefficients }),

    /** Makes the projected shape the design. */
    keep: () => reportErrors(asked({ what: 'keep' })),

    /** Returns to the shape before the variation. */
    leave: () => reportErrors(asked({ what: 'leave' })),

    /** Returns the measures of the kept shapes. @param {number} tolerance */
    table: (tolerance) => asked({ what: 'table', tolerance }),

    /** Returns the positions of a kept shape. @param {number} index */
    positions: (index) => asked({ what: 'positions', index }),
  };
}
