/** The small drawing of a kind: the sample points, faint, and their projection. */

import type { Sketch } from '../../pkg/engine/shape_up.js';

type Point = [number, number];

/** Room around the unit square for dots and strokes. */
const MARGIN = 0.08;
const DOT = 0.045;
const SIZE = 1 + 2 * MARGIN;

/** In the colour of `--chip`; hidden from screen readers. */
export function Drawing({ of: { points, projected, lines, outlines } }: { of: Sketch }) {
  return (
    <svg class="sketch" aria-hidden="true" viewBox={[-MARGIN, -MARGIN, SIZE, SIZE].join(' ')}>
      {outlines.map((outline, i) => (
        <path
          key={i}
          d={`M${outline.map(at).join('L')}Z`}
          class={i === 0 ? 'outline filled' : 'outline'}
        />
      ))}
      <Figure points={points} lines={lines} class="given" />
      <Figure points={projected} lines={lines} class="found" />
    </svg>
  );
}

/** Lines between points, and the points. */
function Figure(props: { points: Point[]; lines: Point[]; class: string }) {
  const { points, lines } = props;
  return (
    <g class={props.class}>
      <path d={lines.map(([from, to]) => `M${at(points[from])}L${at(points[to])}`).join('')} />
      {points.map(([x, y], i) => (
        <circle key={i} cx={x} cy={y} r={DOT} />
      ))}
    </g>
  );
}

function at([x, y]: Point) {
  return `${x.toFixed(4)} ${y.toFixed(4)}`;
}
