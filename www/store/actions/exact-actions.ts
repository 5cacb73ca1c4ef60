/** Actions on the hardness of constraints. */

import type { ExactFound, Require } from '../../solver/types.ts';
import type { SolverClient } from '../../solver/solver-client.ts';
import type { Actions } from '../actions.ts';

export const exactActions = (solver: SolverClient, { reportErrors }: Actions) => ({
  /** Sets the hardness of a row and runs, as one step of undo. */
  require: (index: number, require: Require) =>
    reportErrors(solver.change.editAndRun({ setConstraint: { index, require } })),

  /**
   * Applies a shape that was found, if it belongs to the current one.
   * @param joins merges it into the last step of undo
   */
  accept: ({ shape, positions }: ExactFound, joins: boolean) =>
    reportErrors(solver.change.makeExact(shape, positions, joins)),
});
