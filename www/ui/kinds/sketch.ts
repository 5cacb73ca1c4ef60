/** The small drawing of a kind: the sample points, faint, and their projection. */

import { svgElement } from '../svg.ts';
import type { Sketch } from '../../solver/types.ts';

/** Room around the unit square for dots and strokes. */
const MARGIN = 0.08;
const DOT = 0.045;

/** Makes the drawing, in the colour of `--chip`; hidden from screen readers. */
export function sketch({ points, projected, lines, outlines }: Sketch) {
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

/** Draws lines between points, and the points. */
function figure(points: [number, number][], lines: [number, number][], name: string) {
  const group = svgElement('g', { class: name });
  const d = lines.map(([from, to]) => `M${at(points[from])}L${at(points[to])}`).join('');
  group.append(svgElement('path', { d }));
  for (const [x, y] of points) group.append(svgElement('circle', { cx: x, cy: y, r: DOT }));
  return group;
}

function at([x, y]: [number, number]) {
  return `${x.toFixed(4)} ${y.toFixed(4)}`;
}
