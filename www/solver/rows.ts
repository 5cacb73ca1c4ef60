/** Which row of a list is meant, while edits that the page does not show yet change the list. */

import type { ConstraintRow, Document as SceneDocument, Edit } from '../pkg/engine/shape_up.js';

/** The lists of whose rows edits name the index. */
export type Lists = Pick<SceneDocument, 'constraints' | 'variants'>;

/** A key of a row, by what it is: its index changes when one before it is removed. */
export function keyOf({ kind, on }: ConstraintRow, index: number, rows: ConstraintRow[]) {
  const before = rows.slice(0, index).filter((row) => row.kind === kind && row.on === on);
  return `${kind} ${on} ${before.length}`;
}

/** The index that a row has now; `unclear` if it may have become another one of its kind. */
type Place = number | 'gone' | 'unclear';

/**
 * Returns where a shown constraint is now.
 * @param shown the list in which it was chosen
 */
export function constraintNow(index: number, shown: ConstraintRow[], now: ConstraintRow[]): Place {
  const row = shown[index];
  const [before, after] = [shown, now].map((rows) =>
    rows.filter(({ kind, on }) => kind === row.kind && on === row.on),
  );
  const place = before.indexOf(row);
  if (after.length === before.length) return after[place].index;
  // Where some alike were added or removed, what the row says of itself tells it from them.
  const rest = after.length > before.length ? [after[place]] : after;
  const found = rest.find((one) => saidOf(one) === saidOf(row));
  if (found) return found.index;
  // What no row said before may be this one, changed.
  const said = new Set(before.map(saidOf));
  return after.every((one) => said.has(saidOf(one))) ? 'gone' : 'unclear';
}

const saidOf = ({ name, weight, enabled, require, params }: ConstraintRow) =>
  JSON.stringify([name, weight, enabled, require, params]);

const constraint = (index: number, shown: Lists, now: Lists) =>
  constraintNow(index, shown.constraints, now.constraints);
// Their names are unique.
function variant(index: number, shown: Lists, now: Lists): Place {
  const at = now.variants.indexOf(shown.variants[index]);
  return at < 0 ? 'gone' : at;
}
/** For the edits of a row, how it is found. */
const FOUND: Record<string, typeof constraint | undefined> = {
  ...{ setConstraint: constraint, renameConstraint: constraint },
  ...{ duplicateConstraint: constraint, removeConstraint: constraint },
  ...{ goToVariant: variant, removeVariant: variant },
};

/**
 * Returns an edit with the index that its row has now; null if that is to be removed, and is gone.
 * @param shown the lists in which it was chosen
 * @throws if the row is not found
 */
export function editNow(edit: Edit, shown: Lists, now: Lists): Edit | null {
  const [[name, given]] = Object.entries(edit) as [string, { index: number }][];
  const found = FOUND[name];
  if (!found) return edit;
  const index = found(given.index, shown, now);
  if (typeof index === 'number') return { [name]: { ...given, index } } as Edit;
  if (index === 'gone' && name.startsWith('remove')) return null;
  throw new Error('The list has changed meanwhile, and nothing was done. Try again.');
}
