/** The verdict on making all panels one shape, in words. */

import { count, groupDigits, length } from '../../ui/format.ts';
import type { Verdict } from '../../solver/types.ts';

/**
 * A length to two digits, the precision that matters for building.
 * @param value in the unit of the mesh
 * @param units of the mesh
 */
function about(value: number, units: string) {
  const text = length(Number(value.toPrecision(2)), units);
  return text.replace(/(\.\d*?)0+(?=[ e]|$)/, '$1').replace(/\.(?=[ e]|$)/, '');
}

/**
 * The number of panels within the tolerance.
 * @param units of the mesh
 */
export function progressWords({ adjective, panels, within, tolerance }: Verdict, units: string) {
  const limit = `${adjective} within ${about(tolerance, units)}`;
  if (within < panels)
    return `${groupDigits(within)} of ${groupDigits(panels)} panels are ${limit}.`;
  return panels === 1
    ? `The panel is ${limit}.`
    : `All ${groupDigits(panels)} panels are ${limit}.`;
}

/**
 * The same, with panels that meet only a larger tolerance because they would fold.
 * @param units of the mesh
 */
function reachedWords(verdict: Verdict, units: string) {
  const { panels, within, tolerance, eased } = verdict;
  if (!eased) return progressWords(verdict, units);
  if (eased.panels === panels) {
    const all = progressWords({ ...verdict, within: panels, tolerance: eased.within }, units);
    return `${all} Within ${about(tolerance, units)}, faces would fold.`;
  }
  const one = panels - within === 1;
  const others = one ? 'The other one' : `The other ${panels - within}`;
  return `${progressWords(verdict, units)} ${others} would fold, so ${one ? 'it is' : 'they are'} within ${about(eased.within, units)}.`;
}

/** A change of the surface as a whole, in words. */
function bendWords({ bend: { rest, now, change } }: Verdict) {
  const degrees = (angle: number) => `${angle.toFixed(angle < 9.95 ? 1 : 0)}°`;
  return change
    ? ` The surface became ${change}: neighbours meet at ${degrees(now)} on average, ${degrees(rest)} in your mesh.`
    : '';
}

/**
 * The full verdict, with the worst panel and how far the mesh moved.
 * @param units of the mesh
 */
export function verdictWords(verdict: Verdict, units: string) {
  const { worst, moved, folded } = verdict;
  const folds =
    folded > 0
      ? ` But ${count(folded, 'face')} ${folded === 1 ? 'is' : 'are'} folded or dented.`
      : '';
  const far = `at most ${about(moved.max, units)}, ${about(moved.mean, units)} on average`;
  return `${reachedWords(verdict, units)}${folds}${bendWords(verdict)} Worst ${about(worst, units)}. Your mesh moved by ${far}.`;
}
