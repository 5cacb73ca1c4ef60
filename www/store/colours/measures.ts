/** Measures, their tolerances, and their values in words. */

import { length, lengthOrZero, writtenUnit } from '../../ui/words.ts';
import { panelsCard } from '../panels-card.ts';
import type { FaceMeasure } from '../../pkg/engine/shape_up.js';
import type { Measure } from '../../solver/types.ts';

type State = Readonly<import('../state.ts').State>;

/** Returns the declaration of a measure. */
export const declared = ({ measures }: State, measure: Measure | null): FaceMeasure | undefined =>
  measures.find(({ id }) => id === measure);

/**
 * Returns the tolerance of a measure, in its unit: the model's if it applies, else the one set for
 * this measure; null if there is none.
 */
export function toleranceOf(
  { document, tolerances }: State,
  { id, toleranced, signed }: FaceMeasure,
) {
  if (signed) return null;
  return toleranced ? (document?.tolerance ?? null) : (tolerances[id] ?? null);
}

/**
 * Returns one unit for all values of the measure that colours the faces, and the factor to it: the
 * unit of the tolerance, or else of the greatest value.
 */
export function shownUnit(state: State) {
  const about = declared(state, state.measure);
  if (!about) return { symbol: '', factor: 1 };
  const size = toleranceOf(state, about) ?? state.spread?.axis.high ?? 0;
  return writtenUnit(about.unit, state.document?.units ?? '', size);
}

/** Returns the declaration of the measure that colours the faces, or would by default. */
export const colouring = (state: State) =>
  declared(state, state.measure ?? state.document?.measure ?? null);

/**
 * Returns the largest value of a measure over all faces, in its unit: of the one that colours the
 * faces, or else of the scene's.
 */
export const worstOf = ({ numbers, greatest }: State, measure: Measure) =>
  greatest?.measure === measure ? greatest.value : (numbers?.worstDistance ?? 0);

/** The measure of the distances from the original, of which the legend has the largest and the mean. */
const DISPLACEMENT: Measure = 'displacement';

/** The measure that the legend shows, if any: a flat map has colours of its own. */
export const inLegend = (state: State) =>
  state.flatMap || !state.model?.faces ? undefined : declared(state, state.measure);

/** Whether the legend, or else the status bar, says the largest value of a measure. */
export function isInLegend(state: State, of: Measure | null) {
  if (of === DISPLACEMENT) return true;
  const shown = colouring(state);
  return shown !== undefined && shown.id === of && !shown.signed;
}

/** Whether the legend says the largest value of the measure that colours the faces as their worst. */
export const hasWorst = ({ id }: FaceMeasure) => id !== DISPLACEMENT;

/** Whether the card of the panels counts those within the tolerance of a measure. */
export function isCounted(state: State, { id }: FaceMeasure) {
  const { verdict, running, document, kinds } = state;
  if (panelsCard(state) !== 'verdict') return false;
  if (running) return document?.measure === id;
  return kinds.some(({ id: kind, measure }) => kind === verdict?.report.kind && measure === id);
}

/**
 * Formats the vertices' distances from rest, "0.21 m, mean 0.05 m"; empty until something moves.
 */
export function movedInWords({ numbers, document, model }: State) {
  if (!model || !numbers?.moved || lengthOrZero(numbers.moved.max, model.size) === 0) return '';
  const { max, mean } = numbers.moved;
  const units = document?.units ?? '';
  return `${length(max, units)}, mean ${length(mean, units, max)}`;
}
