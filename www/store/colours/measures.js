/** The measure that fits a scene, the format of its values, and their rounding error. */

import { METRES, length, lengthUnit, number } from '../../ui/format.js';
import { ROUNDING } from '../../ui/rounding.js';

/** @typedef {import("../../solver/messages.js").Measure} Measure */
/** @typedef {import("../../solver/messages.js").FaceMeasure} FaceMeasure */
/** @typedef {Readonly<import("../state.js").State>} State */

const SIGNS = { percent: '%', degrees: '°', number: '' };
/** Exponent of the mesh unit in each unit. @type {Partial<Record<FaceMeasure["unit"], number>>} */
const POWERS = { length: 1, 'per-length': -1, 'per-area': -2 };

/**
 * Returns the declaration of a measure.
 * @param {State} state
 * @param {Measure | null} measure
 * @returns {FaceMeasure | undefined}
 */
export const declared = ({ measures }, measure) => measures.find(({ id }) => id === measure);

/**
 * Returns the bound below which values are rounding errors.
 * @param {FaceMeasure} measure
 * @param {number} size of the mesh
 */
export function roundingOf({ unit }, size) {
  const power = POWERS[unit];
  if (power) return ROUNDING * size ** power;
  // Per cent and degrees have two digits before the point; e_p and e_c are squares.
  return unit === 'number' ? ROUNDING ** 2 : 100 * ROUNDING;
}

/**
 * Returns the tolerance of a measure, in its unit: the model's if it applies, else the one set for
 * this measure; null if there is none.
 * @param {State} state
 * @param {FaceMeasure} measure
 */
export function toleranceOf({ tolerance, tolerances }, { id, toleranced, signed }) {
  if (signed) return null;
  return toleranced ? tolerance : (tolerances[id] ?? null);
}

/**
 * Returns the unit in which values of a size are written and entered, and the factor to it.
 * @param {FaceMeasure} measure
 * @param {number} size of the value; for errors, their tolerance
 * @param {string} units of the mesh
 */
export function unitOf({ unit }, size, units) {
  if (unit === 'length') return lengthUnit(size, units);
  const power = POWERS[unit];
  if (!power) return { unit: SIGNS[/** @type {keyof typeof SIGNS} */ (unit)], factor: 1 };
  // Curvatures are shown in 1/m, so that the radius in metres can be read off.
  const metres = METRES[units];
  return { unit: metres ? `1/m${power < -1 ? '²' : ''}` : '', factor: (metres ?? 1) ** power };
}

/**
 * Formats a value with its unit.
 * @param {FaceMeasure} measure
 * @param {number} value
 * @param {string} units of the mesh
 * @param {number | null} [like] value that determines the unit: for errors, their tolerance
 */
export function valueInWords(measure, value, units, like = null) {
  if (measure.unit === 'length') return length(value, units, like ?? value);
  const { unit, factor } = unitOf(measure, value, units);
  return `${number(value * factor)}${unit.length > 1 || unit === '%' ? ' ' : ''}${unit}`;
}

/**
 * Returns the largest value of a measure over all faces, in its unit: from the latest frame if it
 * colours the faces, else from the numbers that accompany every frame.
 * @param {State} state
 * @param {Measure} measure
 */
export function worstOf({ numbers, spread }, measure) {
  if (spread?.measure === measure) return spread.greatest;
  const always = /** @type {Record<string, any> | null} */ (numbers)?.[measure];
  return always ? always.max_distance : Math.max(0, ...(numbers?.worst ?? []));
}

/**
 * Formats the vertices' distances from rest, "0.21 m, mean 0.05 m"; empty until something moves.
 * @param {State} state
 */
export function movedInWords({ numbers, document, size }) {
  if (!numbers?.moved || numbers.moved.max < ROUNDING * size) return '';
  const { max, mean } = numbers.moved;
  const units = document?.units ?? '';
  return `${length(max, units)}, mean ${length(mean, units, max)}`;
}

/**
 * Returns the measure of the first enabled row that has one; `residual`, the distance to the
 * constraints, if none has one; null without constraints or faces.
 * @param {State} state
 * @returns {Measure | null}
 */
export function measureOfScene({ document, model }) {
  const rows = document?.constraints ?? [];
  if (rows.length === 0 || model?.faces === 0) return null;
  const measured = rows.find(({ enabled, measure }) => enabled && measure !== null);
  return measured?.measure ?? 'residual';
}
