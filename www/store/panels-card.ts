/** What the card of the panels shows, and what may be done to the mesh. */

import type { State } from './state.ts';

/** Whether all panels can be asked to be one shape. */
export const offersPanels = ({ model }: Pick<State, 'model'>) =>
  Boolean(model?.faces && model.panels.length > 0);

/** Whether a constraint asks the panels for a shape, so that there is a verdict on them. */
export const asksPanels = ({ document, kinds }: Pick<State, 'document' | 'kinds'>) =>
  document?.constraints.some(
    ({ enabled, kind }) => enabled && kinds.some(({ id, panels }) => id === kind && panels),
  ) ?? false;

/** What is needed to know what the card shows. */
export const CARD_KEYS = [
  'model',
  'document',
  'kinds',
  'example',
  'flatMap',
  'press',
  'closedCard',
] as const;
type Known = Pick<State, (typeof CARD_KEYS)[number]>;

/** The buttons for a mesh just opened, or how far they came; null if the card is not shown. */
export function panelsCard(state: Known): 'offer' | 'verdict' | null {
  const { model, document, example, flatMap, press, closedCard } = state;
  // The legend of a flat map is in the card's position.
  if (!offersPanels(state) || !document || flatMap || closedCard === model) return null;
  if (press?.model === model && asksPanels(state)) return 'verdict';
  const isOffered = document.constraints.length === 0 && !example;
  return isOffered && !isLocked(state, 'constraints') ? 'offer' : null;
}

/** The verdict on the panels, if the card shows it. */
export const shownVerdict = (state: Known & Pick<State, 'verdict'>) =>
  panelsCard(state) === 'verdict' ? state.verdict : null;

/** Whether a lesson locks this. */
export const isLocked = ({ document }: Pick<State, 'document'>, part: 'mesh' | 'constraints') =>
  document?.lesson?.lock.includes(part) ?? false;
