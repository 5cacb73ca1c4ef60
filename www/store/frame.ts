/** The unit and the vertical axis of the coordinates, and the usual length. */

import type { State } from './state.ts';

/**
 * Returns them as they are now. `guessed`: which of them are those that were guessed when the file was
 * opened, and have not been confirmed.
 */
export function frameOf({
  document,
  model,
  frameChosen,
}: Pick<State, 'document' | 'model' | 'frameChosen'>) {
  const { units, up } = document ?? model ?? { units: '', up: 'z' as const };
  const guessed = {
    units: units === model?.guessed.units && !frameChosen?.units,
    up: up === model?.guessed.up && !frameChosen?.up,
  };
  return { units, up, guessed, meanEdge: model?.meanEdge ?? 0 };
}
