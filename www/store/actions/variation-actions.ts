/** Actions on variations: other shapes that are equally exact. Loaded on first use. */

import type { VariationAnswers, VariationAsk } from '../../solver/messages.ts';
import type { SolverClient } from '../../solver/solver-client.ts';
import type { Actions } from '../actions.ts';

export function variationActions(solver: SolverClient, { reportErrors }: Actions) {
  const asked = async <Ask extends VariationAsk>(
    ask: Ask,
  ): Promise<VariationAnswers[Ask['what']]> => {
    const answer = await solver.request({ type: 'variations', ask });
    return answer as VariationAnswers[Ask['what']];
  };
  return {
    /** Begins the search for variations; returns whether there can be any. */
    find: () => asked({ what: 'find' }),

    /** Continues the search for a moment. */
    advance: () => asked({ what: 'advance' }),

    displacement: (index: number) => asked({ what: 'displacement', index }),

    /** Shows the linear combination of variations at once. */
    show: (coefficients: Float64Array) => asked({ what: 'show', coefficients }),

    /** Moves there and projects back onto the constraints. */
    project: (coefficients: Float64Array) => asked({ what: 'project', coefficients }),

    /** Makes the projected shape the design. */
    keep: () => reportErrors(asked({ what: 'keep' })),

    /** Returns to the shape before the variation. */
    leave: () => reportErrors(asked({ what: 'leave' })),

    /** Returns the measures of the kept shapes. */
    table: (tolerance: number) => asked({ what: 'table', tolerance }),

    /** Returns the positions of a kept shape. */
    positions: (index: number) => asked({ what: 'positions', index }),
  };
}
