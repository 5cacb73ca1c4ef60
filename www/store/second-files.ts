/** Edits that read a second file, chosen or dropped. */

import { unreadable } from '../solver/errors.ts';
import type { Edit } from '../pkg/engine/shape_up.js';
import type { AppContext } from '../app/context.ts';

interface SecondFile {
  edit: (name: string, text: string) => Edit;
  /** what is said when it is done, and has perhaps released the boundary */
  done: (name: string, isReleased: boolean) => string;
}

/** Fitting to another surface. */
export const FIT: SecondFile = {
  edit: (name, text) => ({ fitTo: { name, text } }),
  done: (name, isReleased) =>
    `Vertices stay near ${name}${isReleased ? ', and the boundary is free' : ''}`,
};
/** Rest shapes from another pose. */
export const POSE: SecondFile = {
  edit: (name, text) => ({ takePose: { name, text } }),
  done: (name) => `Shapes are taken from ${name}`,
};

/**
 * Reads the file for the model that is shown, as one step of undo. An alert says why it is refused.
 * @returns rejects if it cannot be read from the disk
 */
export async function readSecondFile(
  { edit, done }: SecondFile,
  file: File,
  { store, actions, files: { replaced } }: AppContext,
) {
  const text = await file.text().catch(unreadable(file));
  if (replaced.aborted)
    return actions.setStatus(`${file.name} was not used: another model was opened meanwhile.`);
  const isFree = () => store.get().document?.settings.boundary === 'off';
  const wasFree = isFree();
  const edited = await actions.edit(edit(file.name, text));
  if (edited !== undefined) actions.setStatus(done(file.name, !wasFree && isFree()));
}
