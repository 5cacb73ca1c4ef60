/** The positions of the kept shapes of a model. */

import type { Actions } from '../../store/actions.ts';
import type { VariantRow } from '../../solver/types.ts';

/**
 * Returns what gives the positions of each, `#V by 3`. A shape that is still kept is not asked for
 * again: it is the same array, of which a picture is drawn once.
 */
export function keptShapes({ variantPositions }: Pick<Actions['ask'], 'variantPositions'>) {
  let known: Map<string, Float64Array> = new Map();
  return async (rows: VariantRow[]) => {
    const shapes: typeof known = new Map();
    for (const [index, { name, moved, area }] of rows.entries()) {
      // A name may have been given again, to another shape.
      const key = JSON.stringify([name, moved, area]);
      shapes.set(key, known.get(key) ?? (await variantPositions(index)));
    }
    known = shapes;
    return [...shapes.values()];
  };
}
