// The page about speed: what `npm run bench` measured, with a plot of cost against size.

import { readFileSync } from 'node:fs';
import { marked } from 'marked';
import { at } from './project.mjs';

/** The text of which the page is made; `npm run bench -- --write` writes its tables. */
const text = () => readFileSync(at('src', 'solve', 'performance.md'), 'utf8');

/** The heading of the table that is plotted, and the columns with problem, size and time. */
const PLOTTED = 'In the browser, milliseconds, medians:';
const [PROBLEM, SIZE, TIME] = [0, 1, 2];

/**
 * The times of an iteration in a text: for each problem its points [vertices, milliseconds].
 * @param {string} markdown
 * @returns {Map<string, [number, number][]>}
 */
export function timesIn(markdown) {
  const table = markdown.slice(markdown.indexOf(PLOTTED)).split('\n\n')[1];
  const rows = table.split('\n').slice(2);
  const times = new Map();
  for (const row of rows) {
    const cells = row.split('|').slice(1, -1);
    // The spread follows the median.
    const [vertices, time] = [SIZE, TIME].map((k) => parseFloat(cells[k].replace(/,/g, '')));
    const problem = cells[PROBLEM].trim();
    times.set(problem, [...(times.get(problem) ?? []), [vertices, time]]);
  }
  return times;
}

/** The exponent of time in size: the slope of the least-squares line through the logarithms. */
export function exponent(points) {
  const logarithms = points.map((point) => point.map(Math.log));
  const mean = (k) => logarithms.reduce((sum, point) => sum + point[k], 0) / logarithms.length;
  const [x, y] = [mean(0), mean(1)];
  const sum = (term) => logarithms.reduce((total, point) => total + term(point), 0);
  return sum(([a, b]) => (a - x) * (b - y)) / sum(([a]) => (a - x) ** 2);
}

const [WIDTH, HEIGHT, MARGIN] = [640, 360, 48];
const written = (value) => value.toLocaleString('en', { maximumSignificantDigits: 3 });

/** The powers of ten around all values. */
function decades(values) {
  const from = Math.floor(Math.log10(Math.min(...values)));
  const to = Math.ceil(Math.log10(Math.max(...values)));
  return Array.from({ length: to - from + 1 }, (_, k) => 10 ** (from + k));
}

/** Returns what places values between two pixels by their logarithms, with a line at each decade. */
function axis(values, from, to) {
  const ticks = decades(values);
  const [least, most] = [ticks[0], ticks.at(-1)].map(Math.log10);
  const place = (value) =>
    (from + ((Math.log10(value) - least) / (most - least)) * (to - from)).toFixed(1);
  return { ticks, place };
}

/** Cost against size in logarithms, with a line for each problem, and what they are below. */
function plot(times) {
  const points = [...times.values()].flat();
  const [left, right, bottom, top] = [MARGIN, WIDTH - MARGIN, HEIGHT - MARGIN, MARGIN / 4];
  const x = axis(
    points.map(([vertices]) => vertices),
    left,
    right,
  );
  const y = axis(
    points.map(([, time]) => time),
    bottom,
    top,
  );
  const grid = [
    ...x.ticks.map((value) => {
      const at = x.place(value);
      return `<path d="M${at} ${bottom}V${top}"/><text x="${at}" y="${bottom + 20}" text-anchor="middle">${written(value)}</text>`;
    }),
    ...y.ticks.map((value) => {
      const at = y.place(value);
      return `<path d="M${left} ${at}H${right}"/><text x="${left - 8}" y="${at}" dy="4" text-anchor="end">${written(value)}</text>`;
    }),
  ];
  const lines = [...times].map(([problem, its]) => {
    const places = its.map(([vertices, time]) => `${x.place(vertices)} ${y.place(time)}`);
    return `<path class="${problem}" d="M${places.join('L')}"/>`;
  });
  const legend = [...times].map(
    ([problem, its]) =>
      `<li><svg viewBox="0 0 32 8" aria-hidden="true"><path class="${problem}" d="M0 4H32"/></svg>${problem}: the size to the power of ${exponent(its).toFixed(2)}</li>`,
  );
  return `<svg class="plot" role="img" aria-labelledby="plotted" viewBox="0 0 ${WIDTH} ${HEIGHT}">${[...grid, ...lines].join('')}</svg><ul>${legend.join('')}</ul>`;
}

/** Inserts text, tables and plot into the template of the page. @param {string} html */
export function speedTexts(html) {
  const markdown = text().replace(/^# .*\n/, '');
  // Comments mark what the bench writes.
  const plain = marked.parse(markdown.replace(/<!--.*?-->\n/g, ''), { async: false });
  // Wide tables scroll in themselves, also by keys.
  const body = plain
    .replaceAll('<table>', '<div class="scrolled" tabindex="0"><table>')
    .replaceAll('</table>', '</table></div>');
  return html
    .replace('<!-- plot -->', () => plot(timesIn(markdown)))
    .replace('<!-- text -->', () => body);
}
