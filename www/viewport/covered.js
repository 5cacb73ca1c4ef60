/** What lies along the lower edge of the view: whatever is framed is seen whole above all of it. */

/** Between the model and what lies below it, in CSS pixels. */
const GAP = 14;

/** How much of the view each of them covers, in CSS pixels. @type {Map<HTMLElement, number>} */
const heights = new Map();

/**
 * Takes note of what an element over the view covers of it now.
 * @param {import("./viewport.js").Viewport} viewport
 * @param {HTMLElement} element
 * @param {boolean} [isAlong] whether it lies along the edge, if it is seen
 * @returns {number} how much it covers, in CSS pixels
 */
export function cover(viewport, element, isAlong = true) {
  const { hidden, offsetTop, offsetParent } = element;
  const height = offsetParent?.clientHeight ?? 0;
  const covered = !isAlong || hidden || !height ? 0 : height - offsetTop + GAP;
  heights.set(element, covered);
  viewport.with((view) => view.cover(Math.max(...heights.values())));
  return covered;
}
