/** The positions of the kept shapes of a model. */

import type { Actions } from '../../store/actions.ts';
import type { VariantRow } from '../../pkg/engine/shape_up.js';

/**
 * Returns what gives the positions of each, `#V by 3`. Those before the first change of the list are
 * not asked for again: they are the same arrays, of which a picture is drawn once.
 */
export function keptShapes({ variantPositions }: Pick<Actions['ask'], 'variantPositions'>) {
  let known: { about: string; shape: Float64Array }[] = [];
  return async (rows: VariantRow[]) => {
    // Another shape may have the name of one that was removed, and even its numbers.
    const abouts = rows.map(({ name, moved, area }) => JSON.stringify([name, moved, area]));
    const changed = known.findIndex(({ about }, index) => about !== abouts[index]);
    const now = changed < 0 ? [...known] : known.slice(0, changed);
    for (let index = now.length; index < rows.length; index++)
      now.push({ about: abouts[index], shape: await variantPositions(index) });
    known = now;
    return now.map(({ shape }) => shape);
  };
}
