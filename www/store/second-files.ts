/** Edits that read a second file, chosen or dropped. */

import { unreadable } from '../solver/errors.ts';
import type { Edit } from '../pkg/engine/shape_up.js';
import type { Actions } from './actions.ts';

interface SecondFile {
  edit: (name: string, text: string) => Edit;
  /** what is said when it is done */
  done: (name: string) => string;
}

/** Fitting to another surface. */
export const FIT: SecondFile = {
  edit: (name, text) => ({ fitTo: { name, text } }),
  done: (name) => `Vertices stay near ${name}`,
};
/** Rest shapes from another pose. */
export const POSE: SecondFile = {
  edit: (name, text) => ({ takePose: { name, text } }),
  done: (name) => `Shapes are taken from ${name}`,
};

/**
 * Reads the file, as one step of undo. An alert says why it is refused.
 * @param replaced aborted when another model is shown than the one that it was chosen for
 * @returns rejects if it cannot be read from the disk
 */
export async function readSecondFile(
  { edit, done }: SecondFile,
  file: File,
  actions: Actions,
  replaced: AbortSignal,
) {
  const text = await file.text().catch(unreadable(file));
  if (replaced.aborted)
    return actions.setStatus(`${file.name} was not used: another model was opened meanwhile.`);
  const edited = await actions.edit(edit(file.name, text));
  if (edited !== undefined) actions.setStatus(done(file.name));
}
