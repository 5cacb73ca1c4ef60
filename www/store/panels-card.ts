/** What the card of the panels shows, and what may be done to the mesh. */

import { isEmbedded } from '../ui/embedded.ts';
import type { LessonWords } from '../pkg/engine/shape_up.js';
import type { State } from './state.ts';

/** Whether all panels can be asked to be one shape. */
export const offersPanels = ({ model }: Pick<State, 'model'>) =>
  Boolean(model?.faces && model.panels.length > 0);

/** Whether a constraint asks the panels for a shape, so that there is a verdict on them. */
export const asksPanels = ({ document, kinds }: Pick<State, 'document' | 'kinds'>) =>
  document?.constraints.some(
    ({ enabled, kind }) => enabled && kinds.some(({ id, panels }) => id === kind && panels),
  ) ?? false;

/** What is needed to know what there is to say of the panels. */
export const TOPIC_KEYS = ['model', 'document', 'kinds', 'example', 'press', 'closedCard'] as const;
type Known = Pick<State, (typeof TOPIC_KEYS)[number]>;

/**
 * What there is to say of the panels, wherever there is room for it: the buttons for a mesh just
 * opened, or how far they came; null if nothing is, or the user has closed it.
 */
export function panelsTopic(state: Known): 'offer' | 'verdict' | null {
  const { document, example, press, closedCard } = state;
  if (!offersPanels(state) || !document || closedCard) return null;
  if (press && asksPanels(state)) return 'verdict';
  const isOffered = document.constraints.length === 0 && !example;
  return isOffered && !isLocked(state, 'constraints') ? 'offer' : null;
}

/**
 * What of it the card over the view shows. It is there if and only if this is not null: where there
 * is no room for it, others have what is on it.
 */
export function panelsCard(
  state: Known & Pick<State, 'flatMap' | 'docked' | 'corner' | 'presenting' | 'room'>,
): ReturnType<typeof panelsTopic> {
  const { flatMap, docked, corner, presenting, room } = state;
  // The legend of a flat map is in the card's position; a docked panel leaves room for the model only.
  if (isEmbedded || presenting || flatMap || docked || corner === 'new-panels') return null;
  if (corner === 'curvature' && room !== 'wide') return null;
  const topic = panelsTopic(state);
  return topic === 'verdict' && room === 'sheet' ? null : topic;
}

/** Title of a control that a lesson locks. */
export const LOCKED = 'Locked by the lesson';

/** What a lesson may lock. */
export type Lock = LessonWords['lock'][number];

/** Whether a lesson locks this. */
export const isLocked = ({ document }: Pick<State, 'document'>, part: Lock) =>
  document?.lesson?.lock.includes(part) ?? false;

/**
 * Whether a lesson leaves it to the student which shape is kept: it becomes the one that closeness
 * keeps to, and takes the handles that are not fixed along.
 */
export const mayKeepShapes = (state: Pick<State, 'document'>) =>
  !isLocked(state, 'weights') &&
  !(isLocked(state, 'handles') && state.document?.handles.some(({ fixed }) => !fixed));
