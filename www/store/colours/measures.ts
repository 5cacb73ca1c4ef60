/** Measures, their tolerances, and their values in words. */

import { length, lengthOrZero, writtenUnit } from '../../ui/words.ts';
import type { ConstraintRow, FaceMeasure, Measure } from '../../solver/types.ts';

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

/**
 * Returns the largest value of a measure over all faces, in its unit: of the one that colours the
 * faces, or else of the scene's.
 */
export const worstOf = ({ numbers, greatest }: State, measure: Measure) =>
  greatest?.measure === measure ? greatest.value : (numbers?.worstPanel ?? 0);

/** Whether the largest value of a measure is the worst one of the legend. */
export const isWorst = ({ measure, spread }: State, of: Measure | null) =>
  spread !== null && of !== null && of === measure;

/** Whether the largest distance of a row of constraints is the worst value of the legend. */
export function isColoured(state: State, row: ConstraintRow) {
  const { document, model, kinds } = state;
  const isOnly = document?.constraints.filter(({ enabled }) => enabled).length === 1;
  if (isOnly && isWorst(state, 'residual')) return true;
  const measure = kinds.find(({ id }) => id === row.kind)?.measure ?? null;
  return row.count === model?.faces && isWorst(state, measure);
}

/** Whether the verdict on the panels, which is shown, counts those within the tolerance of a measure. */
export function isCounted({ verdict, kinds }: State, { id }: FaceMeasure) {
  const kind = verdict && !verdict.isClosed ? verdict.report.kind : null;
  return kinds.some((one) => one.id === kind && one.measure === id);
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
