/** The flat map beside the model. Loaded on first use. */

import type { Feature } from '../../app/context.ts';

export default {
  commands: (app) => [
    {
      id: 'parametrize',
      group: 'View',
      label: 'Flatten: a flat map beside the model',
      keys: ['U'],
      action: () =>
        import('./flat-map-controller.ts').then((it) => it.FlatMapController.of(app).toggle()),
      needsModel: true,
      enabled: ({ model }) => Boolean(model?.faces),
      pressed: ({ flatMap }) => flatMap !== null,
    },
  ],
} satisfies Feature;
