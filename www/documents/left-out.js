/** Words on what was given with a model and not opened. Comes when something was. */

import { isReadable } from '../solver/opened-files.js';

/**
 * What was taken of the files and folders that were given together, and why not the others.
 * @param {string[]} taken names
 * @param {string[]} files names of the others
 * @param {string[]} folders names
 */
export function leftOut(taken, files, folders) {
  const reasons = [
    ...files.map((name) => {
      const reason = isReadable({ name }) ? 'one model at a time' : 'neither a mesh nor a scene';
      return `${name} (${reason})`;
    }),
    ...folders.map((name) => `${name} (a folder: open the files in it)`),
  ];
  return `Opened ${taken.join(' with ')}. Left out: ${reasons.join(', ')}.`;
}
