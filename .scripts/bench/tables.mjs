// Tables in Markdown, each declared by its columns.

const missing = '–';

/** Three significant digits, but no more than three decimals. */
const rounded = new Intl.NumberFormat('en', {
  ...{ minimumSignificantDigits: 3, maximumSignificantDigits: 3 },
  ...{ minimumFractionDigits: 3, maximumFractionDigits: 3 },
  roundingPriority: 'lessPrecision',
});

/** Formats a number; one that is tiny as a power of ten. */
export function number(value) {
  if (!Number.isFinite(value)) return missing;
  if (Number.isInteger(value)) return value.toLocaleString('en');
  return Math.abs(value) < 1e-3 ? value.toExponential(0) : rounded.format(value);
}

/** Formats a spread: its ends, unless they are as the median, or that there was one run only. */
function spreadText({ median, low, high, runs }, also = []) {
  const texts = [median, low, high].map(number);
  const ends = texts.every((text) => text === texts[0]) ? [] : [`${texts[1]}–${texts[2]}`];
  const inside = [...(runs === 1 ? ['once'] : ends), ...also].join('; ');
  return inside ? `${texts[0]} (${inside})` : texts[0];
}

/** Formats a text, a number, a spread, or seconds with the iterations in them; null if they are not enough. */
function cell(value) {
  if (typeof value === 'string') return value;
  if (typeof value !== 'object' || value === null) return number(value);
  if (!('seconds' in value)) return spreadText(value);
  const { seconds, iterations } = value;
  return iterations === null
    ? `> ${number(seconds.median)}`
    : spreadText(seconds, [`${number(iterations)} iterations`]);
}

/** Returns the value of a row at a path such as `browser.none.total`. */
const valueAt = (row, path) => path.split('.').reduce((value, key) => value?.[key], row);

/**
 * Returns a table of the rows with a measurement in it, or null if there are none. `columns` is its
 * head: for each column a title and the path of its values, which may be the title. Measurements
 * are those inside of others, at a path with a dot. Columns without any value are left out.
 */
export function table(columns, all) {
  const heads = columns.split('|').map((column) => column.trim().split(' = '));
  const measured = heads.map(([, path = '']) => path).filter((path) => path.includes('.'));
  const rows = all.filter((row) => measured.some((path) => valueAt(row, path) !== undefined));
  if (!rows.length) return null;
  const filled = heads
    .map(([head, path = head]) => [head, ...rows.map((row) => cell(valueAt(row, path)))])
    .filter(([, ...cells]) => cells.some((text) => text !== missing));
  const [head, ...lines] = ['', ...rows].map(
    (_, k) => `| ${filled.map((column) => column[k]).join(' | ')} |`,
  );
  return [head, `|${'---|'.repeat(filled.length)}`, ...lines].join('\n');
}
