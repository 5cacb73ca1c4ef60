/** The goals of a lesson in words. */

import { roundingOf, valueInWords } from '../../store/colours/measures.ts';
import { count } from '../../ui/format.ts';
import type { FaceMeasure, LessonWords } from '../../solver/types.ts';

type Goal = LessonWords['goals'][number];

/** Returns the measure of a goal. */
function measureOf({ measure, label, words, unit }: Goal): FaceMeasure {
  const about = { id: measure ?? '', label, words, unit, met: '' };
  return { ...about, toleranced: unit === 'length', curvature: false, signed: false };
}

/** @param units of the mesh */
export function goalInWords(goal: Goal, units: string) {
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

/** Whether a goal bounds a number of parts. */
const isCount = ({ build, unit }: Goal) => build !== null && unit === 'number';

/** The current value of a goal in words. */
export function nowInWords(
  goal: Goal,
  value: number,
  { units, size }: { units: string; size: number },
) {
  if (goal.beyond !== null) return count(value, 'panel');
  if (isCount(goal)) return String(value);
  const measure = measureOf(goal);
  const shown = value < roundingOf(measure, size) ? 0 : value;
  // In the unit of the goal, so that the two can be compared.
  return valueInWords(measure, shown, units, goal.atMost || null);
}
