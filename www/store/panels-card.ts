/** What the card of the panels shows, and what may be done to the mesh. */

import type { State } from './state.ts';

/** Whether all panels can be asked to be one shape. */
export const offersPanels = ({ model }: Pick<State, 'model'>) =>
  Boolean(model?.faces && model.panels.length > 0);

type Known = Pick<State, 'model' | 'document' | 'example' | 'flatMap' | 'press' | 'closedCard'>;

/** The buttons for a mesh just opened, or how far they came; null if the card is not shown. */
export function panelsCard(state: Known): 'offer' | 'verdict' | null {
  const { model, document, example, flatMap, press, closedCard } = state;
  // The legend of a flat map is in the card's position.
  if (!offersPanels(state) || !document || flatMap || closedCard === model) return null;
  const rows = document.constraints.length;
  if (press?.model === model && rows > 0) return 'verdict';
  return rows === 0 && !example && !isLocked(state, 'constraints') ? 'offer' : null;
}

/** Whether a lesson locks this. */
export const isLocked = ({ document }: Pick<State, 'document'>, part: 'mesh' | 'constraints') =>
  document?.lesson?.lock.includes(part) ?? false;
