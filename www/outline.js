/** The outline of a histogram, drawn over the bars of another one. */

const SPACE = 'http://www.w3.org/2000/svg';

/** An outline without bars; `drawOutline` gives it some. */
export function outline() {
  const svg = document.createElementNS(SPACE, 'svg');
  svg.setAttribute('class', 'outline');
  svg.setAttribute('aria-hidden', 'true');
  svg.setAttribute('preserveAspectRatio', 'none');
  svg.append(document.createElementNS(SPACE, 'path'));
  return svg;
}

/**
 * @param {SVGSVGElement} svg
 * @param {number[] | null} counts per bar; without them there is no outline
 * @param {number} most the count that is as high as the drawing
 */
export function drawOutline(svg, counts, most) {
  svg.toggleAttribute('hidden', !counts);
  if (!counts) return;
  svg.setAttribute('viewBox', `0 0 ${counts.length} 1`);
  const steps = counts.map((count, k) => {
    const y = Math.round(1e4 * (1 - count / Math.max(most, 1))) / 1e4;
    return `L${k} ${y}L${k + 1} ${y}`;
  });
  svg.firstElementChild?.setAttribute('d', `M0 1${steps.join('')}L${counts.length} 1`);
}
