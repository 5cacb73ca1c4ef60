/** Elements along the lower edge of the view: the camera frames the model above them. */

/** Gap between the model and these elements, in CSS pixels. */
const GAP = 14;

/** Height of the view covered by each element, in CSS pixels. @type {Map<HTMLElement, number>} */
const heights = new Map();

/**
 * Records how much of the view an element covers.
 * @param {import("./viewport.js").Viewport} viewport
 * @param {HTMLElement} element
 * @param {boolean} [isAlong] whether it lies along the lower edge when visible
 * @returns {number} covered height, in CSS pixels
 */
export function cover(viewport, element, isAlong = true) {
  const { hidden, offsetTop, offsetParent } = element;
  const height = offsetParent?.clientHeight ?? 0;
  const covered = !isAlong || hidden || !height ? 0 : height - offsetTop + GAP;
  heights.set(element, covered);
  viewport.with((view) => view.cover(Math.max(...heights.values())));
  return covered;
}
