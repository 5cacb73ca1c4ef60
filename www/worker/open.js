/** Opens the files of a model in the worker. */

import { messageOf } from '../solver/messages.js';
import { filesNamed, mainOf } from '../solver/opened-files.js';
import { isTrap } from './wasm-errors.js';

/** @typedef {import("../pkg/engine/shape_up.js").Solver} Solver */
/** @typedef {Extract<import("../solver/messages.js").Request, { type: "open" }>} Open */

/**
 * @param {Solver} solver
 * @param {import("./scheduler.js").Scheduler} scheduler
 * @param {Open} message
 * @returns {import("../solver/messages.js").Loaded}
 */
export function open(solver, scheduler, { files, saved, frame = '', solved, weld }) {
  const main = mainOf(files);
  const named = filesNamed(files, (scene) => solver.sceneFiles(scene));
  solver.setDefaultFrame(frame);
  solver.keepUnwelded(weld === false);
  for (const { path, file } of named) if (file) solver.addFile(path, file.bytes);
  const read = scheduler.replace(() => solver.load(main.name, main.bytes));
  /** @type {import("../solver/messages.js").Loaded} */
  const loaded = {
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
 * @param {Solver} solver
 * @param {import("../solver/messages.js").Saved} saved
 * @returns {string} reason why its undo history is lost; empty if it is not
 */
function restore(solver, { iteration, history, progress }) {
  solver.restoreIteration(iteration);
  try {
    solver.restore(history ?? new Uint8Array(0), progress ?? new Uint8Array(0));
    return '';
  } catch (thrown) {
    if (isTrap(thrown)) throw thrown;
    return messageOf(thrown);
  }
}

/**
 * Returns the paths of files that the main file names and that are missing.
 * @param {Solver} solver
 * @param {import("../solver/messages.js").NamedBytes[]} files
 */
export function missingFiles(solver, files) {
  const named = filesNamed(files, (scene) => solver.sceneFiles(scene));
  return named.filter(({ file }) => !file).map(({ path }) => path);
}
