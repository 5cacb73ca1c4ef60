/**
 * Loads rhino3dm, McNeel's reader and writer of Rhino files. It is larger than the rest of the
 * page, so its own worker (`rhino-worker.ts`) loads it when a Rhino file is read or written.
 */

import open from 'rhino3dm/rhino3dm.module.min.js';
import module from 'rhino3dm/rhino3dm.wasm?url';
import { UNITS } from '../../ui/units.ts';

export function rhino(): Promise<any> {
  return open({ locateFile: () => module }).catch((error: unknown) => {
    throw new Error('The .3dm converter could not be loaded. Check the network.', {
      cause: error,
    });
  });
}

/** Key of the user text that gives the role of a polyline. */
export const ROLE = 'shape-up';

/** Rhino's name of each unit symbol. */
export const NAMES: Record<string, string> = Object.fromEntries(
  UNITS.map(({ symbol, rhino }) => [symbol, rhino]),
);
