/** Which constraint a row of the list is, while other rows come and go. */

import type { ConstraintRow } from '../pkg/engine/shape_up.js';

/** A key of a row, by what it is: its index changes when one before it is removed. */
export function keyOf({ kind, on }: ConstraintRow, index: number, rows: ConstraintRow[]) {
  const before = rows.slice(0, index).filter((row) => row.kind === kind && row.on === on);
  return `${kind} ${on} ${before.length}`;
}
