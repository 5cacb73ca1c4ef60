/** Actions on the whole mesh: one press for all panels, and changes of the mesh itself. */

import { openEdit } from './open-edit.ts';
import type { Feature } from '../../app/context.ts';

export default {
  commands: (app) => [
    {
      id: 'edit-mesh',
      group: 'Edit',
      label: 'Edit mesh',
      keys: [],
      enabled: ({ model, document }) =>
        Boolean(model?.faces && !model.tets && !document?.lesson?.lock.includes('mesh')),
      action: () => openEdit(app),
    },
  ],
  parts: [
    {
      keys: ['fileName'],
      isNeeded: ({ fileName }) => fileName !== '',
      load: (app) => import('./card.ts').then((it) => new it.MakePanels(app)),
    },
  ],
} satisfies Feature;
