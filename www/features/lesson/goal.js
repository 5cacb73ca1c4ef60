/** The goals of a lesson in words. */

import { roundingOf, valueInWords } from '../../store/colours/measures.js';
import { count } from '../../ui/format.js';

/** @typedef {import("../../solver/messages.js").LessonWords["goals"][number]} Goal */

/**
 * Returns the measure of a goal.
 * @param {Goal} goal
 * @returns {import("../../solver/messages.js").FaceMeasure}
 */
export function measureOf({ measure, label, words, unit }) {
  const about = { id: measure ?? '', label, words, unit, met: '' };
  return { ...about, toleranced: unit === 'length', curvature: false, signed: false };
}

/**
 * @param {Goal} goal
 * @param {string} units of the mesh
 */
export function goalInWords(goal, units) {
  if (goal.beyond !== null) {
    const beyond = valueInWords(measureOf(goal), goal.beyond, units);
    if (goal.atMost === 0) return `${goal.label}: no panel beyond ${beyond}`;
    return `${goal.label} beyond ${beyond}: at most ${count(goal.atMost, 'panel')}`;
  }
  if (goal.measure === null && !goal.build && goal.atMost === 0) return `${goal.label} exact`;
  if (isCount(goal)) return `${goal.label}: at most ${goal.atMost}`;
  const most = valueInWords(measureOf(goal), goal.atMost, units);
  return `Worst ${goal.label.toLowerCase()} at most ${most}`;
}

/** Whether a goal bounds a number of parts. @param {Goal} goal */
const isCount = ({ build, unit }) => build !== null && unit === 'number';

/**
 * The current value of a goal in words.
 * @param {Goal} goal
 * @param {number} value
 * @param {{ units: string, size: number }} model
 */
export function nowInWords(goal, value, { units, size }) {
  if (goal.beyond !== null) return count(value, 'panel');
  if (isCount(goal)) return String(value);
  const measure = measureOf(goal);
  const shown = value < roundingOf(measure, size) ? 0 : value;
  // In the unit of the goal, so that the two can be compared.
  return valueInWords(measure, shown, units, goal.atMost || null);
}
