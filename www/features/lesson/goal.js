/** A goal of a lesson in words. */

import { valueInWords } from '../../store/colours/measures.js';

/** @typedef {import("../../solver/messages.js").LessonWords["goals"][number]} Goal */

/**
 * A goal as the measure that it is about.
 * @param {Goal} goal
 * @returns {import("../../solver/messages.js").FaceMeasure}
 */
export function measureOf({ measure, label, words, unit }) {
  return { id: measure ?? '', label, words, unit, met: '', toleranced: unit === 'length' };
}

/**
 * @param {Goal} goal
 * @param {string} units of the mesh
 */
export function goalInWords(goal, units) {
  if (goal.measure === null && goal.atMost === 0) return `${goal.label} exact`;
  const most = valueInWords(measureOf(goal), goal.atMost, units);
  return `Worst ${goal.label.toLowerCase()} at most ${most}`;
}
