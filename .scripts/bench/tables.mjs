// Tables in Markdown, each declared by its columns.

const missing = '–';

/** Formats a number with three significant digits, or as a power of ten if it is tiny. */
export function number(value) {
  if (!Number.isFinite(value)) return missing;
  if (Number.isInteger(value)) return value.toLocaleString('en');
  if (Math.abs(value) < 1e-3) return value.toExponential(0);
  const digits = Math.max(0, 2 - Math.floor(Math.log10(Math.max(Math.abs(value), 0.01))));
  return value.toFixed(Math.min(3, digits));
}

/** Formats a text, a number, or seconds with the iterations in them; null if they are not enough. */
function cell(value) {
  if (typeof value === 'string') return value;
  if (typeof value !== 'object') return number(value);
  const { seconds, iterations } = value;
  return iterations === null
    ? `> ${number(seconds)}`
    : `${number(seconds)} (${number(iterations)})`;
}

/** Returns the value of a row at a path such as `browser.none.total`. */
const valueAt = (row, path) => path.split('.').reduce((value, key) => value?.[key], row);

/**
 * Returns a table of the rows that have a value at the path `has`, or null if there are none.
 * `columns` is its head: for each column a title and the path of its values, which may be the title.
 * Columns without any value are left out.
 */
export function table({ has, columns }, all) {
  const rows = all.filter((row) => valueAt(row, has) !== undefined);
  const filled = columns
    .split('|')
    .map((column) => column.trim().split(' = '))
    .map(([head, path = head]) => [head, ...rows.map((row) => cell(valueAt(row, path)))])
    .filter(([, ...cells]) => cells.some((text) => text !== missing));
  const line = (k) => `| ${filled.map((column) => column[k]).join(' | ')} |`;
  const lines = rows.map((_, k) => line(k + 1));
  return rows.length ? [line(0), `|${'---|'.repeat(filled.length)}`, ...lines].join('\n') : null;
}
