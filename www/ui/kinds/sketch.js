/** The small drawing of a kind: the sample points, faint, and their projection. */

import { svgElement } from '../svg.js';

/** Room around the unit square for dots and strokes. */
const MARGIN = 0.08;
const DOT = 0.045;

/**
 * Makes the drawing, in the colour of `--chip`; hidden from screen readers.
 * @param {import("../../solver/messages.js").Sketch} drawing
 */
export function sketch({ points, projected, lines, outlines }) {
  const svg = svgElement('svg', { class: 'sketch', 'aria-hidden': 'true' });
  const size = 1 + 2 * MARGIN;
  svg.setAttribute('viewBox', `${-MARGIN} ${-MARGIN} ${size} ${size}`);
  outlines.forEach((outline, i) => {
    const d = `${outline
      .map(at)
      .reduce((path, point) => `${path}L${point}`, '')
      .replace('L', 'M')}Z`;
    svg.append(svgElement('path', { d, class: i === 0 ? 'outline filled' : 'outline' }));
  });
  svg.append(figure(points, lines, 'given'), figure(projected, lines, 'found'));
  return svg;
}

/**
 * Draws lines between points, and the points.
 * @param {[number, number][]} points
 * @param {[number, number][]} lines
 * @param {string} name
 */
function figure(points, lines, name) {
  const group = svgElement('g', { class: name });
  const d = lines.map(([from, to]) => `M${at(points[from])}L${at(points[to])}`).join('');
  group.append(svgElement('path', { d }));
  for (const [x, y] of points) group.append(svgElement('circle', { cx: x, cy: y, r: DOT }));
  return group;
}

/** @param {[number, number]} point */
function at([x, y]) {
  return `${x.toFixed(4)} ${y.toFixed(4)}`;
}
