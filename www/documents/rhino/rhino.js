/**
 * McNeel's reader and writer of Rhino files, rhino3dm. It is larger than all the rest of the page, and
 * comes in a worker of its own (`rhino-worker.js`) when a file of Rhino is read or written.
 */

import open from 'rhino3dm/rhino3dm.module.min.js';
import module from 'rhino3dm/rhino3dm.wasm?url';
import { UNITS } from '../../ui/units.js';

/** @returns {Promise<typeof import("rhino3dm")["RhinoModule"] | any>} */
export function rhino() {
  return open({ locateFile: () => module }).catch((/** @type {unknown} */ error) => {
    throw new Error('The part for .3dm files could not be loaded. Check the network.', {
      cause: error,
    });
  });
}

/** The user text that says what a polyline is. */
export const ROLE = 'shape-up';

/** The name of each unit here in Rhino. @type {Record<string, string>} */
export const NAMES = Object.fromEntries(UNITS.map(({ symbol, rhino }) => [symbol, rhino]));
