/** Histograms of the corner angles before and after (paper Fig. 7). */

import { element } from '../../ui/dom.ts';
import { svgElement } from '../../ui/svg.ts';

const [WIDTH, HEIGHT] = [180, 46];

/**
 * @param counts of corners in bins of equal width from 0 to 180 degrees, at the
 *   start and at the end
 */
export function angleHistogram([before, after]: [number[], number[]]) {
  const most = Math.max(...before, ...after);
  return element(
    'div.angles',
    histogram('Angles at the start', before, most),
    histogram('Angles when solved', after, most),
  );
}

/** @param most maximum of both */
function histogram(title: string, counts: number[], most: number) {
  const width = 180 / counts.length;
  const total = counts.reduce((sum, count) => sum + count, 0);
  // Bins whose centre is within 10 degrees of a right angle.
  const right = counts.filter((_, k) => Math.abs((k + 0.5) * width - 90) < 10);
  const share = Math.round((100 * right.reduce((sum, count) => sum + count, 0)) / total);
  const bars = counts.map((count, k) => {
    const height = (HEIGHT * count) / most;
    const x = (k * WIDTH) / counts.length;
    return svgElement('rect', {
      x,
      y: HEIGHT - height,
      width: WIDTH / counts.length - 0.6,
      height,
    });
  });
  const words = `${title}: ${share} per cent are within 10 degrees of 90 degrees`;
  const attributes = { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'img', 'aria-label': words };
  const svg = svgElement('svg', attributes, ...bars);
  const ends = ['0°', '90°', '180°'].map((text) => element('span', text));
  return element(
    'figure',
    svg,
    element('div.ends', { 'aria-hidden': 'true' }, ...ends),
    element('figcaption', `${title}: ${share} % near 90°`),
  );
}
