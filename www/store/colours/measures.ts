/** Measures, their tolerances, and their values in words. */

import { METRES, length, lengthUnit, number } from '../../ui/format.ts';
import { ROUNDING } from '../../ui/rounding.ts';
import type { FaceMeasure, Measure } from '../../solver/types.ts';

type State = Readonly<import('../state.ts').State>;

const SIGNS = { percent: '%', degrees: '°', number: '' };
/** Exponent of the mesh unit in each unit. */
const POWERS: Partial<Record<FaceMeasure['unit'], number>> = {
  length: 1,
  'per-length': -1,
  'per-area': -2,
};

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
 * Returns the unit in which values of a size are written and entered, and the factor to it.
 * @param size of the value; for errors, their tolerance
 * @param units of the mesh
 */
export function unitOf({ unit }: FaceMeasure, size: number, units: string) {
  if (unit === 'length') return lengthUnit(size, units);
  const power = POWERS[unit];
  if (!power) return { unit: SIGNS[unit as keyof typeof SIGNS], factor: 1 };
  // Curvatures are shown in 1/m, so that the radius in metres can be read off.
  const metres = METRES[units];
  return { unit: metres ? `1/m${power < -1 ? '²' : ''}` : '', factor: (metres ?? 1) ** power };
}

/**
 * Returns one unit for all values of the measure that colours the faces, and the factor to it: the
 * unit of the tolerance, or else of the greatest value.
 */
export function shownUnit(state: State) {
  const about = declared(state, state.measure);
  if (!about) return { unit: '', factor: 1 };
  const size = toleranceOf(state, about) ?? state.spread?.axis.high ?? 0;
  return unitOf(about, size, state.document?.units ?? '');
}

/**
 * Formats a value with its unit.
 * @param units of the mesh
 * @param like value that determines the unit: for errors, their tolerance
 */
export function valueInWords(
  measure: FaceMeasure,
  value: number,
  units: string,
  like: number | null = null,
) {
  if (measure.unit === 'length') return length(value, units, like ?? value);
  const { unit, factor } = unitOf(measure, value, units);
  return `${number(value * factor)}${unit.length > 1 || unit === '%' ? ' ' : ''}${unit}`;
}

/**
 * Returns the largest value of a measure over all faces, in its unit: of the one that colours the
 * faces, or else of the scene's.
 */
export const worstOf = ({ numbers, greatest }: State, measure: Measure) =>
  greatest?.measure === measure ? greatest.value : (numbers?.worstPanel ?? 0);

/**
 * Formats the vertices' distances from rest, "0.21 m, mean 0.05 m"; empty until something moves.
 */
export function movedInWords({ numbers, document, model }: State) {
  if (!model || !numbers?.moved || numbers.moved.max < ROUNDING * model.size) return '';
  const { max, mean } = numbers.moved;
  const units = document?.units ?? '';
  return `${length(max, units)}, mean ${length(mean, units, max)}`;
}
