/** What one shape of all panels would do to the mesh, in words of the second worker. */

import { useRef } from 'preact/hooks';
import { useAnswerTo } from './use-answer.ts';
import { useApp } from './use-app.ts';
import type { ForecastWords } from '../pkg/engine/shape_up.js';

/**
 * Asks once for each model and unit, in which the words have lengths.
 * @param isWanted whether it is shown
 * @returns null if there is no forecast, undefined until it is known
 */
export function useForecastWords(isWanted: boolean): ForecastWords | null | undefined {
  const { store, actions } = useApp();
  const { model, document } = store.state;
  const units = document?.units;
  const wanted = useRef<unknown>(null);
  if (isWanted) wanted.current = model;
  const isAsked = wanted.current === model && units !== undefined;
  const { answer, isCurrent } = useAnswerTo([isAsked, model, units], () =>
    isAsked ? actions.trials.forecast().catch(() => null) : undefined,
  );
  return isCurrent ? answer : undefined;
}
