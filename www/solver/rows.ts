/** Which row of a list is meant, while edits that the page does not show yet change the list. */

import type { Document as SceneDocument, Edit } from '../pkg/engine/shape_up.js';

/** The lists of whose rows edits name the index. */
export type Lists = Pick<SceneDocument, 'constraints' | 'variants'>;
/** What a row keeps: a constraint its number, a kept shape its name, which is unique. */
export type RowKey = number | string;

const constraints = (lists: Lists): RowKey[] => lists.constraints.map(({ number }) => number);
const variants = (lists: Lists): RowKey[] => lists.variants;
/** For the edits of a row, the keys of its list. */
const KEYS: Record<string, ((lists: Lists) => RowKey[]) | undefined> = {
  ...{ setConstraint: constraints, renameConstraint: constraints },
  ...{ duplicateConstraint: constraints, removeConstraint: constraints },
  ...{ goToVariant: variants, removeVariant: variants },
};

/**
 * Returns an edit with the index that its row has now; null if that is to be removed, and is gone.
 * @throws if the row is gone
 */
export function editNow(edit: Edit, row: RowKey, now: Lists): Edit | null {
  const [name, given] = Object.entries(edit)[0] as [string, { index: number }];
  const index = KEYS[name]?.(now).indexOf(row) ?? given.index;
  if (index >= 0) return { [name]: { ...given, index } } as Edit;
  if (name.startsWith('remove')) return null;
  throw new Error('The list has changed meanwhile, and nothing was done. Try again.');
}
