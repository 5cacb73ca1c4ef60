/** The fitted shapes, shown although the user has not asked for them. */

import type { Actions } from '../store/actions.ts';
import type { Files } from './files.ts';

/** Hides them when another work has been opened. */
export function hideWithNextWork(files: Pick<Files, 'on'>, actions: Pick<Actions, 'display'>) {
  const stop = files.on('opened', () => {
    stop();
    actions.display({ shapes: false });
  });
}
