/** The SVG drawings of the page about projections, in view box coordinates. */

import { svgElement } from '../../ui/dom.ts';
import { number } from '../../ui/words.ts';
import { sum, type Point, type ConstraintSet } from './sets.ts';

const CURVE_REACH = 60;

/**
 * Draws the plane with the sets, the point and its projections.
 * @param names of the sets
 */
export function drawPlane(
  svg: SVGSVGElement,
  names: string[],
  input: { move: (to: Point) => void; key: (event: KeyboardEvent) => void },
) {
  const curves = svgElement('g', { 'aria-hidden': 'true' });
  const trail = svgElement('path', { class: 'trail', 'aria-hidden': 'true' });
  const feet = names.map((_, i) =>
    svgElement(
      'g',
      { class: `foot set-${i}`, 'aria-hidden': 'true' },
      svgElement('line', {}),
      svgElement('circle', { r: 0.7 }),
    ),
  );
  const point = svgElement(
    'g',
    { class: 'point', tabindex: 0, role: 'button', 'aria-roledescription': 'movable point' },
    svgElement('circle', { class: 'grip', r: 6 }),
    svgElement('circle', { class: 'dot', r: 1.2 }),
  );
  svg.replaceChildren(curves, trail, ...feet, point);

  const placeOf = (event: PointerEvent): Point => {
    const matrix = svg.getScreenCTM();
    if (!matrix) return [0, 0];
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    return [x, y];
  };
  svg.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    svg.setPointerCapture(event.pointerId);
    event.preventDefault();
    point.focus();
    input.move(placeOf(event));
  });
  svg.addEventListener('pointermove', (event) => {
    if (svg.hasPointerCapture(event.pointerId)) input.move(placeOf(event));
  });
  point.addEventListener('keydown', input.key);

  return {
    showSets(sets: ConstraintSet[]) {
      const drawn = sets.map((set, i) =>
        svgElement('path', { class: `curve set-${i}`, d: outline(set) }),
      );
      const labels = sets.map((set, i) => {
        const [x, y] = labelAt(set);
        const label = svgElement('text', { class: `label set-${i}`, x, y });
        label.textContent = names[i];
        return label;
      });
      curves.replaceChildren(...drawn, ...labels);
    },

    show(x: Point, targets: Point[] | null, been: Point[], glides: boolean) {
      point.classList.toggle('glides', glides);
      point.style.transform = `translate(${x[0]}px, ${x[1]}px)`;
      const [across, down] = x.map(number);
      point.setAttribute(
        'aria-label',
        `Point at ${across}, ${down}. Arrow keys move it, with Shift by less.`,
      );
      const way = [...been, x].map((place) => place.join(' ')).join('L');
      trail.setAttribute('d', been.length ? `M${way}` : '');
      feet.forEach((foot, i) => {
        const target = targets?.[i];
        foot.toggleAttribute('hidden', !target);
        if (!target) return;
        const [line, dot] = foot.children;
        const ends = { x1: x[0], y1: x[1], x2: target[0], y2: target[1] };
        for (const [key, value] of Object.entries(ends)) line.setAttribute(key, String(value));
        dot.setAttribute('cx', String(target[0]));
        dot.setAttribute('cy', String(target[1]));
      });
    },
  };
}

/** The SVG path data of a set. */
function outline(set: ConstraintSet) {
  const [x, y] = set.at;
  if (set.kind === 'circle') {
    const r = set.radius;
    return `M${x - r} ${y}a${r} ${r} 0 1 1 ${2 * r} 0a${r} ${r} 0 1 1 ${-2 * r} 0z`;
  }
  const points = [];
  const [reach, steps] = set.kind === 'line' ? [2 * CURVE_REACH, 1] : [CURVE_REACH, 96];
  for (let k = -steps; k <= steps; k++) points.push(along(set, (reach * k) / steps).join(' '));
  return `M${points.join('L')}`;
}

function along(set: Exclude<ConstraintSet, { kind: 'circle' }>, u: number) {
  const v = set.kind === 'line' ? 0 : set.bend * u * u;
  const [c, s] = [Math.cos(set.turn), Math.sin(set.turn)];
  return [set.at[0] + c * u - s * v, set.at[1] + s * u + c * v];
}

function labelAt(set: ConstraintSet) {
  const [x, y] = set.at;
  if (set.kind === 'circle') return [x, y + set.radius + 3];
  if (set.kind === 'parabola') return [x, y + 3];
  const [u, v] = along(set, 44);
  return [u, v - 1.5];
}

/** Draws the proximity of each half step as a stacked bar. */
export function drawBars(svg: SVGSVGElement, bars: { label: string; errors: number[] }[]) {
  const [width, height, foot] = [300, 150, 18];
  const most = Math.max(1e-12, ...bars.map(({ errors }) => sum(errors)));
  const wide = 20;
  const gap = width / 12;
  const made = bars.flatMap(({ label, errors }, k) => {
    let top = height - foot;
    const parts = errors.map((error, i) => {
      const tall = ((height - foot - 4) * error) / most;
      top -= tall;
      return svgElement('rect', {
        class: `part set-${i}`,
        x: k * gap + 2,
        y: top,
        width: wide,
        height: tall,
      });
    });
    const text = svgElement('text', { class: 'tick', x: k * gap + 2 + wide / 2, y: height - 4 });
    text.textContent = label.split(',')[0];
    return [...parts, text];
  });
  const ground = svgElement('line', {
    class: 'ground',
    x1: 0,
    x2: width,
    y1: height - foot,
    y2: height - foot,
  });
  svg.replaceChildren(ground, ...made);
  const [first, last] = [bars[0], bars[bars.length - 1]];
  const words =
    bars.length === 0
      ? 'No step yet'
      : `φ falls from ${number(sum(first.errors))} to ${number(sum(last.errors))} in ${bars.length} half steps`;
  svg.setAttribute('aria-label', words);
}
