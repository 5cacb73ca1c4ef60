// Cells and tables in Markdown.

/** Placeholder for a missing number. */
export const missing = '–';

/** Formats a number with three significant digits, or a dash. */
export function number(value) {
  if (value === null || value === undefined || !Number.isFinite(value)) return missing;
  if (Number.isInteger(value)) return value.toLocaleString('en');
  const digits = Math.max(0, 2 - Math.floor(Math.log10(Math.max(Math.abs(value), 0.01))));
  return value.toFixed(Math.min(3, digits));
}

/** Formats bytes as megabytes. */
export const megabytes = (bytes) => number(bytes === undefined ? null : bytes / 1e6);

/** Returns a table with a head and rows of cells. */
export function table(head, rows) {
  const line = (cells) => `| ${cells.join(' | ')} |`;
  return [line(head), `|${'---|'.repeat(head.length)}`, ...rows.map(line)].join('\n');
}
