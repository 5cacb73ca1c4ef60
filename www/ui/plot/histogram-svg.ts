/** Histograms as SVG: bars, or an outline drawn over them. */

import { setAttribute } from '../dom.ts';
import { svgElement } from '../svg.ts';

/** The least relative height of a non-empty bar: one outlier among thousands must be visible. */
const LEAST = 1 / 15;

function drawing(look: 'outline' | 'bars') {
  const attributes = { class: look, 'aria-hidden': 'true', preserveAspectRatio: 'none' };
  return svgElement('svg', attributes, svgElement('path'));
}

/** Makes an empty drawing for `drawOutline`. */
export const outline = () => drawing('outline');
/** Makes an empty drawing for `drawBars`. */
export const bars = () => drawing('bars');

/**
 * @param counts per bar; null hides the outline
 * @param most the count at full height
 */
export function drawOutline(svg: SVGSVGElement, counts: number[] | null, most: number) {
  svg.toggleAttribute('hidden', !counts);
  if (!counts) return;
  setAttribute(svg, 'viewBox', `0 0 ${counts.length} 1`);
  const steps = counts.map((count, k) => {
    const y = Math.round(1e4 * (1 - count / Math.max(most, 1))) / 1e4;
    return `L${k} ${y}L${k + 1} ${y}`;
  });
  const path = `M0 1${steps.join('')}L${counts.length} 1`;
  if (svg.firstElementChild) setAttribute(svg.firstElementChild, 'd', path);
}

/** @param counts per bar; the greatest has full height */
export function drawBars(svg: SVGSVGElement, counts: number[]) {
  const most = Math.max(...counts, 1);
  const least = LEAST * most;
  drawOutline(
    svg,
    counts.map((count) => (count > 0 ? Math.max(count, least) : 0)),
    most,
  );
}
