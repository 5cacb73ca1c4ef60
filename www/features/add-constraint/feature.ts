/** Adding a constraint: a dialog docked over the Model panel. */

import type { Feature } from '../../app/context.ts';

export default {
  commands: (app) => [
    {
      id: 'add-constraint',
      group: 'Edit',
      label: 'Add constraint',
      keys: [],
      action: () => import('./dialog-add-constraint.ts').then((it) => it.toggleAddConstraint(app)),
      needsModel: true,
    },
  ],
} satisfies Feature;
