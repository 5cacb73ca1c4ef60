/** The unit and the vertical axis of the coordinates, and the usual length. */

import type { State } from './state.ts';

/**
 * Returns them as they are now: the user may change unit and axis, of which the model knows only what
 * they were when it was opened.
 */
export function frameOf({ document, model }: Pick<State, 'document' | 'model'>) {
  const { units, up } = document ?? model ?? { units: '', up: 'z' as const };
  return { units, up, meanEdge: model?.meanEdge ?? 0 };
}
