/** Opens the files of a model in the worker. */

import { isTrap, messageOf } from '../solver/errors.ts';
import { filesNamed, mainOf } from '../solver/opened-files.ts';
import type { Solver } from '../pkg/engine/shape_up.js';
import type { Opened, NamedBytes, Saved } from '../solver/types.ts';
import type { Scheduler } from './scheduler.ts';

export interface Opening {
  files: NamedBytes[];
  /** data saved with a scene */
  saved?: Saved;
  /** the numbers of the constraints of a scene that another worker had open */
  rows?: number[];
  /** unit and axis of a mesh file that has none: `# units: m`, `# up: y` */
  frame?: string;
  /** runs before anything is shown, only for the page's own first example, which converges quickly */
  solved?: boolean;
  /** opens no more faces than these */
  most?: number;
  /** false keeps the separate vertices of faces in a mesh file */
  weld?: boolean;
}

/** Returns the number of faces if there are too many, and opens nothing then. */
export function open(
  solver: Solver,
  scheduler: Scheduler,
  { files, saved, rows = [], frame = '', solved, most, weld }: Opening,
): Opened | number {
  const main = mainOf(files);
  // Of a scene alone, which may be large, `read` says what is missing.
  const named = files.length > 1 ? filesNamed(files, (scene) => solver.sceneFiles(scene)) : [];
  for (const { path, file } of named) if (file) solver.addFile(path, file.bytes);
  const tooMany = solver.read(main.name, main.bytes, frame, weld === false, most);
  if (tooMany !== undefined) return tooMany;
  const read = scheduler.replace(() => solver.openRead(main.name, Uint32Array.from(rows)));
  const loaded: Opened = {
    ...read,
    files: [main.name, ...named.map(({ file }) => file?.name ?? '')],
    undoLost: saved ? restore(solver, saved) : '',
  };
  scheduler.begin(solved ?? false);
  scheduler.sendModel(loaded);
  scheduler.changed();
  return loaded;
}

/**
 * Restores the saved state of the scene that was just opened.
 * @returns reason why its undo history is lost; empty if it is not
 */
function restore(solver: Solver, { iteration, history, progress }: Saved): string {
  solver.restoreIteration(iteration);
  try {
    solver.restore(history ?? new Uint8Array(0), progress ?? new Uint8Array(0));
    return '';
  } catch (thrown) {
    if (isTrap(thrown)) throw thrown;
    return messageOf(thrown);
  }
}

/** Returns the paths of files that the main file names and that are missing. */
export function missingFiles(solver: Solver, files: NamedBytes[]) {
  const named = filesNamed(files, (scene) => solver.sceneFiles(scene));
  return named.filter(({ file }) => !file).map(({ path }) => path);
}
