/** What Undo takes back, in words. */

import type { State } from './state.ts';

/**
 * Names it; empty if there is nothing. A run that is under way becomes a step of its own, unless it
 * belongs to the press that began it.
 */
export function undone({
  document,
  undoes,
  running,
  press,
  model,
}: Pick<State, 'document' | 'undoes' | 'running' | 'press' | 'model'>) {
  const isOfPress = press?.isUnderWay && press.model === model;
  if (running && !isOfPress) return 'Run';
  return document?.undo || undoes;
}
