/** The unit and the vertical axis of the coordinates, and the usual length. */

import type { State } from './state.ts';

/**
 * Returns them as they are now: the user may change unit and axis, of which the model knows only what
 * they were when it was opened. `guessed`: which of them are still those that were guessed then, and
 * have not been confirmed.
 */
export function frameOf({
  document,
  model,
  frameChosen,
}: Pick<State, 'document' | 'model' | 'frameChosen'>) {
  const { units, up } = document ?? model ?? { units: '', up: 'z' as const };
  const isAsOpened = units === model?.units && up === model.up;
  const isConfirmed = frameChosen?.model === model && frameChosen?.isGuess;
  const guessed = { units: false, up: false, ...(isAsOpened && !isConfirmed && model.guessed) };
  return { units, up, guessed, meanEdge: model?.meanEdge ?? 0 };
}
