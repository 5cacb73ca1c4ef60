/** Actions on the hardness of constraints. Loaded on first use. */

import type { Require } from '../../solver/types.ts';
import type { SolverClient } from '../../solver/solver-client.ts';
import type { Actions } from '../actions.ts';

export const exactActions = (solver: SolverClient, { reportErrors }: Actions) => ({
  /** Sets the hardness of a row and runs, as one step of undo. */
  require: (index: number, require: Require) =>
    reportErrors(solver.change.editAndRun({ type: 'setConstraint', index, require })),

  /** Returns the cost of meeting constraints exactly instead of within a distance. */
  offer: () => solver.ask.exactOffer(),

  /** Searches for an equally exact shape of lower energy; returns how far it came. */
  improve: () => solver.ask.improvement(),

  /** Ends the search and keeps its result. */
  endTrial: () => solver.ask.endTrial(),

  /**
   * Applies the last offer.
   * @param joins merges it into the last step of undo
   */
  accept: (joins: boolean) => reportErrors(solver.change.makeExact(joins)),
});
