/** Elements along the lower edge of the view: the camera frames the model above them. */

import type { Viewport } from './viewport.ts';

/** Gap between the model and these elements, in CSS pixels. */
const GAP = 14;

/** Height of the view covered by each element, in CSS pixels. */
const heights: Map<HTMLElement, number> = new Map();

/**
 * Records how much of the view an element covers.
 * @param isAlong whether it lies along the lower edge when visible
 * @returns covered height, in CSS pixels
 */
export function cover(viewport: Viewport, element: HTMLElement, isAlong: boolean = true): number {
  const { hidden, offsetTop, offsetParent } = element;
  const height = offsetParent?.clientHeight ?? 0;
  const covered = !isAlong || hidden || !height ? 0 : height - offsetTop + GAP;
  heights.set(element, covered);
  viewport.with((view) => view.cover(Math.max(...heights.values())));
  return covered;
}
