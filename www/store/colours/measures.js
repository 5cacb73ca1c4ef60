/** Which measure of faces a scene is about, how its values read, and what is nothing but rounding. */

import { METRES, length, lengthUnit, number } from '../../ui/format.js';
import { ROUNDING } from '../../ui/rounding.js';

/** @typedef {import("../../solver/messages.js").Measure} Measure */
/** @typedef {import("../../solver/messages.js").FaceMeasure} FaceMeasure */
/** @typedef {Readonly<import("../state.js").State>} State */

const SIGNS = { percent: '%', degrees: '°', number: '' };
/** The power of the unit of the mesh that a unit is. @type {Partial<Record<FaceMeasure["unit"], number>>} */
const POWERS = { length: 1, 'per-length': -1, 'per-area': -2 };

/**
 * The declaration of a measure.
 * @param {State} state
 * @param {Measure | null} measure
 * @returns {FaceMeasure | undefined}
 */
export const declared = ({ measures }, measure) => measures.find(({ id }) => id === measure);

/**
 * Values below this are rounding.
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
 * What may be off: the tolerance of the model where that applies, else the one that somebody set for
 * this measure. In its unit; null where there is none.
 * @param {State} state
 * @param {FaceMeasure} measure
 */
export function toleranceOf({ tolerance, tolerances }, { id, toleranced, signed }) {
  if (signed) return null;
  return toleranced ? tolerance : (tolerances[id] ?? null);
}

/**
 * The unit in which values of this size are written and entered, and the factor to it.
 * @param {FaceMeasure} measure
 * @param {number} size of the value; of errors, their tolerance
 * @param {string} units of the mesh
 */
export function unitOf({ unit }, size, units) {
  if (unit === 'length') return lengthUnit(size, units);
  const power = POWERS[unit];
  if (!power) return { unit: SIGNS[/** @type {keyof typeof SIGNS} */ (unit)], factor: 1 };
  // Curvatures are read by their radius, in metres.
  const metres = METRES[units];
  return { unit: metres ? `1/m${power < -1 ? '²' : ''}` : '', factor: (metres ?? 1) ** power };
}

/**
 * A value with its unit.
 * @param {FaceMeasure} measure
 * @param {number} value
 * @param {string} units of the mesh
 * @param {number | null} [like] the value that decides the unit: errors have that of their tolerance
 */
export function valueInWords(measure, value, units, like = null) {
  if (measure.unit === 'length') return length(value, units, like ?? value);
  const { unit, factor } = unitOf(measure, value, units);
  return `${number(value * factor)}${unit.length > 1 || unit === '%' ? ' ' : ''}${unit}`;
}

/**
 * The largest value of a measure over all faces, in its unit: of the newest frame where the faces
 * are coloured by it, else from the numbers that every frame brings.
 * @param {State} state
 * @param {Measure} measure
 */
export function worstOf({ numbers, spread }, measure) {
  if (spread?.measure === measure) return spread.greatest;
  const always = /** @type {Record<string, any> | null} */ (numbers)?.[measure];
  return always ? always.max_distance : Math.max(0, ...(numbers?.worst ?? []));
}

/**
 * How far the vertices are from where they were: "0.21 m, mean 0.05 m"; empty until something moves.
 * @param {State} state
 */
export function movedInWords({ numbers, document, size }) {
  if (!numbers?.moved || numbers.moved.max < ROUNDING * size) return '';
  const { max, mean } = numbers.moved;
  const units = document?.units ?? '';
  return `${length(max, units)}, mean ${length(mean, units, max)}`;
}

/**
 * The measure of what is asked of the faces: of the first row that is on and has one. The distance
 * to the constraints where rows ask for something that no other tells, none where nothing is asked
 * or there are no faces.
 * @param {State} state
 * @returns {Measure | null}
 */
export function measureOfScene({ document, model }) {
  const rows = document?.constraints ?? [];
  if (rows.length === 0 || model?.faces === 0) return null;
  const measured = rows.find(({ enabled, measure }) => enabled && measure !== null);
  return measured?.measure ?? 'residual';
}
