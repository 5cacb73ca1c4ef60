/** Opens the Edit mesh dialog, from whichever control. Its code is loaded on first use. */

import { oneAtATime } from '../../ui/once.ts';
import type { AppContext } from '../../app/context.ts';

export const openEdit = oneAtATime((app: AppContext, operation: string | undefined = undefined) =>
  import('./refine-operation.ts').then((it) => it.openEdit(app, operation)),
);
