/** Curvature: principal directions and lines of curvature on the surface, and colours. */

import type { Feature } from '../../app/context.ts';

export default {
  commands: (app) => [
    {
      id: 'curvature',
      group: 'View',
      label: 'Curvature',
      keys: [],
      action: () => import('./curvature-card.ts').then((it) => it.toggle(app)),
      needsModel: true,
      enabled: ({ model, renderer }) => Boolean(model?.faces) && renderer !== 'none',
    },
  ],
} satisfies Feature;
