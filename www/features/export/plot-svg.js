/** The convergence as a figure: energies over iterations on a logarithmic scale, as SVG on white. */

const SIZE = { width: 640, height: 400, left: 76, right: 96, top: 24, bottom: 48 };
/** In the order of the table, with colours that print. */
const SERIES = [
  { label: 'shape', colour: '#1f5fc4' },
  { label: 'close', colour: '#b8560b' },
  { label: 'smooth', colour: '#1d7a4f' },
  { label: 'handles', colour: '#8a3fa6' },
  { label: 'total', colour: '#1d2123' },
];
/** Energies this far below the greatest are off the scale. */
const DECADES = 14;
/** Names at the ends of the lines are at least so far apart. */
const LEAST_GAP = 14;
const MOST_TICKS = 6;

/**
 * @param {string} csv the table of the iterations, as the solver writes it
 * @param {string} title
 * @param {string} units of the energies, empty when not known
 */
export function convergenceSvg(csv, title, units) {
  const rows = csv.trim().split('\n').slice(1);
  const table = rows.map((row) => row.split(',').map(Number));
  const iterations = table.map(([iteration]) => iteration);
  const energies = SERIES.map((_, i) => table.map((row) => row[i + 1]));
  // Where all energies are nothing, any scale will do.
  const greatest = energies.flat().reduce((a, b) => Math.max(a, b), 0) || 1;
  const drawn = energies.flat().filter((value) => value > greatest * 10 ** -DECADES);
  const low = Math.floor(Math.log10(drawn.reduce((a, b) => Math.min(a, b), greatest)));
  const high = Math.max(Math.ceil(Math.log10(greatest)), low + 1);
  const last = Math.max(iterations.at(-1) ?? 0, 1);

  const { width, height, left, right, top, bottom } = SIZE;
  const x = (/** @type {number} */ iteration) => left + (iteration / last) * (width - left - right);
  const y = (/** @type {number} */ energy) =>
    top + ((high - Math.log10(energy)) / (high - low)) * (height - top - bottom);

  const lines = SERIES.map(({ label, colour }, i) => {
    const points = energies[i]
      .map((energy, row) => ({ at: x(iterations[row]), energy }))
      .filter(({ energy }) => energy >= 10 ** low);
    const end = points.at(-1);
    const path = points.map(({ at, energy }) => `${round(at)},${round(y(energy))}`).join(' ');
    return { label, colour, path, end: end && y(end.energy), at: end?.at ?? 0 };
  }).filter(({ end }) => end !== undefined);

  const parts = [
    ...decades(low, high).map((exponent) => {
      const at = round(y(10 ** exponent));
      return (
        `<line x1="${left}" x2="${width - right}" y1="${at}" y2="${at}" stroke="#d9dad6"/>` +
        `<text x="${left - 8}" y="${at + 4}" text-anchor="end">10<tspan dy="-5" font-size="9">${minus(exponent)}</tspan></text>`
      );
    }),
    ...ticks(last).map(
      (iteration) =>
        `<text x="${round(x(iteration))}" y="${height - bottom + 18}" text-anchor="middle">${iteration}</text>`,
    ),
    ...lines.map(
      ({ colour, path, label }) =>
        `<polyline points="${path}" fill="none" stroke="${colour}" stroke-width="${label === 'total' ? 2 : 1.25}" stroke-linejoin="round"/>`,
    ),
    ...apart(lines).map(
      ({ label, colour, at, end }) =>
        `<text x="${round(at + 6)}" y="${round(end + 4)}" fill="${colour}">${label}</text>`,
    ),
    `<text x="${(left + width - right) / 2}" y="${height - 10}" text-anchor="middle">iteration</text>`,
    `<text transform="translate(16 ${(top + height - bottom) / 2}) rotate(-90)" text-anchor="middle">energy${units ? ` in ${escape(units)}` : ''}</text>`,
    `<text x="${left}" y="14" font-weight="600">${escape(title)}</text>`,
  ];
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" ` +
    `font-family="Helvetica, Arial, sans-serif" font-size="12" fill="#1d2123">\n` +
    `<rect width="${width}" height="${height}" fill="#ffffff"/>\n${parts.join('\n')}\n</svg>\n`
  );
}

/**
 * Names that would lie on each other are moved down.
 * @template {{ end?: number }} Line
 * @param {Line[]} lines
 */
function apart(lines) {
  let free = -Infinity;
  return [...lines]
    .sort((a, b) => (a.end ?? 0) - (b.end ?? 0))
    .map((line) => {
      const end = Math.max(line.end ?? 0, free);
      free = end + LEAST_GAP;
      return { ...line, end };
    });
}

/**
 * @param {number} low
 * @param {number} high
 */
function decades(low, high) {
  const stride = Math.ceil((high - low) / MOST_TICKS);
  const found = [];
  for (let exponent = high; exponent >= low; exponent -= stride) found.push(exponent);
  return found;
}

/** Round numbers up to the last iteration. @param {number} last */
function ticks(last) {
  const rough = last / MOST_TICKS;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = Math.max(1, [1, 2, 5, 10].map((k) => k * power).find((k) => k >= rough) ?? rough);
  return Array.from({ length: Math.floor(last / step) + 1 }, (_, i) => i * step);
}

/** @param {number} value */
function round(value) {
  return Math.round(value * 100) / 100;
}

/** @param {number} exponent */
function minus(exponent) {
  return String(exponent).replace('-', '−');
}

/** @param {string} text */
function escape(text) {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}
