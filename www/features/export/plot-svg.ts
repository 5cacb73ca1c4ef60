/** The convergence plot as a figure: energies over iterations. */

import { DECADES, SERIES } from '../../ui/plot/energies.ts';
import { tickExponents } from '../../ui/plot/ticks.ts';
import { brief } from '../../ui/words.ts';

/** Of the figure, with its margins. */
const SIZE = { width: 640, height: 400, left: 76, right: 128, top: 24, bottom: 48 };
/** The least distance between the labels at the ends of lines. */
const LEAST_GAP = 14;
const MOST_TICKS = 6;

/** Colours for print, for successive lines. */
const PRINTED = ['#1f5fc4', '#b8560b', '#1d7a4f', '#8a3fa6', '#1d2123'];

/**
 * Draws the energies over a logarithmic scale as an SVG file for print.
 * @param columns the iterations, then one per energy; values that are not positive are not drawn
 * @param units of the energies; empty if unknown
 */
export function convergenceSvg(columns: number[][], title: string, units: string) {
  const [iterations, ...energies] = columns;
  const values = energies.flat();
  // If all values are zero, any scale will do.
  const greatest = values.reduce((a, b) => Math.max(a, b), 0) || 1;
  const drawn = values.filter((value) => value > greatest * 10 ** -DECADES);
  const low = Math.floor(Math.log10(drawn.reduce((a, b) => Math.min(a, b), greatest)));
  const high = Math.max(Math.ceil(Math.log10(greatest)), low + 1);
  const last = iterations.at(-1) || 1;

  const { width, height, left, right, top, bottom } = SIZE;
  const x = (place: number) => left + (place / last) * (width - left - right);
  const y = (value: number) =>
    top + ((high - Math.log10(value)) / (high - low)) * (height - top - bottom);

  const lines = SERIES.map(({ id, width }, i) => {
    const points = energies[i]
      .map((value, row) => ({ at: x(iterations[row]), value }))
      .filter(({ value }) => value >= 10 ** low);
    const end = points.at(-1);
    const path = points.map(({ at, value }) => `${round(at)},${round(y(value))}`).join(' ');
    return {
      label: id,
      colour: PRINTED[i],
      width,
      path,
      end: end && y(end.value),
      at: end?.at ?? 0,
    };
  }).filter(({ end }) => end !== undefined);

  const parts = [
    ...tickExponents(low, high).map((exponent) => {
      const at = round(y(10 ** exponent));
      return (
        `<line x1="${left}" x2="${width - right}" y1="${at}" y2="${at}" stroke="#d9dad6"/>` +
        `<text x="${left - 8}" y="${at + 4}" text-anchor="end">10<tspan dy="-5" font-size="9">${brief(exponent)}</tspan></text>`
      );
    }),
    ...ticks(last).map(
      (place) =>
        `<text x="${round(x(place))}" y="${height - bottom + 18}" text-anchor="middle">${brief(place)}</text>`,
    ),
    ...lines.map(
      ({ colour, path, width }) =>
        `<polyline points="${path}" fill="none" stroke="${colour}" stroke-width="${width}" stroke-linejoin="round"/>`,
    ),
    ...apart(lines).map(
      ({ label, colour, at, end }) =>
        `<text x="${round(at + 6)}" y="${round(end + 4)}" fill="${colour}">${label}</text>`,
    ),
    `<text x="${(left + width - right) / 2}" y="${height - 10}" text-anchor="middle">iteration</text>`,
    `<text transform="translate(16 ${(top + height - bottom) / 2}) rotate(-90)" text-anchor="middle">energy${units && ` in ${escape(units)}`}</text>`,
    `<text x="${left}" y="14" font-weight="600">${escape(title)}</text>`,
  ];
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" ` +
    `font-family="Helvetica, Arial, sans-serif" font-size="12" fill="#1d2123">\n` +
    `<rect width="${width}" height="${height}" fill="#ffffff"/>\n${parts.join('\n')}\n</svg>\n`
  );
}

/** Moves overlapping labels down. */
function apart<Placed extends { end?: number }>(lines: Placed[]) {
  let free = -Infinity;
  return [...lines]
    .sort((a, b) => (a.end ?? 0) - (b.end ?? 0))
    .map((line) => {
      const end = Math.max(line.end ?? 0, free);
      free = end + LEAST_GAP;
      return { ...line, end };
    });
}

/** Returns round numbers up to `last`. */
function ticks(last: number) {
  const rough = last / MOST_TICKS;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((k) => k >= rough) ?? rough;
  return Array.from({ length: Math.floor(last / step + 1e-9) + 1 }, (_, i) => i * step);
}

function round(value: number) {
  return Math.round(value * 100) / 100;
}

function escape(text: string) {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}
