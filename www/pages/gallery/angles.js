/** Histograms of the corner angles before and after (paper Fig. 7). */

import { element } from '../../ui/dom.js';

const SPACE = 'http://www.w3.org/2000/svg';
const [WIDTH, HEIGHT] = [180, 46];

/**
 * @param {[number[], number[]]} counts of corners in bins of equal width from 0 to 180 degrees, at the
 *   start and at the end
 */
export function angleHistogram([before, after]) {
  const most = Math.max(...before, ...after);
  return element(
    'div.angles',
    histogram('Angles at the start', before, most),
    histogram('Angles when solved', after, most),
  );
}

/**
 * @param {string} title
 * @param {number[]} counts
 * @param {number} most maximum of both
 */
function histogram(title, counts, most) {
  const width = 180 / counts.length;
  const total = counts.reduce((sum, count) => sum + count, 0);
  // Bins whose centre is within 10 degrees of a right angle.
  const right = counts.filter((_, k) => Math.abs((k + 0.5) * width - 90) < 10);
  const share = Math.round((100 * right.reduce((sum, count) => sum + count, 0)) / total);
  const svg = document.createElementNS(SPACE, 'svg');
  svg.setAttribute('viewBox', `0 0 ${WIDTH} ${HEIGHT}`);
  svg.setAttribute('role', 'img');
  svg.setAttribute('aria-label', `${title}: ${share} per cent are within 10 degrees of 90 degrees`);
  counts.forEach((count, k) => {
    const bar = document.createElementNS(SPACE, 'rect');
    const height = (HEIGHT * count) / most;
    bar.setAttribute('x', String((k * WIDTH) / counts.length));
    bar.setAttribute('y', String(HEIGHT - height));
    bar.setAttribute('width', String(WIDTH / counts.length - 0.6));
    bar.setAttribute('height', String(height));
    svg.append(bar);
  });
  const ends = ['0°', '90°', '180°'].map((text) => element('span', text));
  return element(
    'figure',
    svg,
    element('div.ends', { 'aria-hidden': 'true' }, ...ends),
    element('figcaption', `${title}: ${share} % near 90°`),
  );
}
