/** A second file as the reference surface of the open mesh, in place of its own rest shape. */

import type { Actions } from '../../store/actions.ts';

/**
 * Sets the reference surface, as one step of undo. An alert explains why a file is refused.
 * @param file OBJ, OFF or Medit
 */
export async function fitTo(file: File, actions: Actions) {
  const text = await file.text();
  await actions.edit({ fitTo: { name: file.name, text } });
}
