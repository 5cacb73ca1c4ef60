/** What the page still knows when the solver has another model. */

import { NOTHING } from './selection.ts';
import type { SolverClient } from '../solver/solver-client.ts';
import type { Loaded } from '../solver/types.ts';
import type { State } from './state.ts';

/** Returns the changes of the state: the view outlasts another mesh, and a press another worker. */
export function withModel(
  loaded: Loaded,
  { restoring, isMeshBack }: Pick<SolverClient, 'restoring' | 'isMeshBack'>,
): Partial<State> {
  return {
    ...(!restoring && {
      ...{ camera: null, views: [], measureChosen: false, tolerances: {}, refining: false },
      ...{ frameChosen: null, section: null, fitted: null },
    }),
    ...(!isMeshBack && { press: null, closedCard: false }),
    model: loaded,
    document: null,
    numbers: null,
    greatest: null,
    halfway: false,
    flatMap: null,
    heldOriginal: null,
    selection: NOTHING,
    dragged: [],
    dragMs: 0,
    tints: {},
    tape: null,
  };
}
