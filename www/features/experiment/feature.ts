/** Comparisons of methods: the experiment of an example, or the general one for any scene. */

import type { Feature } from '../../app/context.ts';

export default {
  commands: (app) => [
    {
      id: 'compare-methods',
      group: 'Solver',
      label: 'Compare methods: how fast each lowers the energy',
      keys: [],
      action: () => import('./compare.ts').then((it) => it.compareMethods(app)),
      needsModel: true,
      enabled: ({ document }) => Boolean(document?.constraints.length),
      title: ({ document }) =>
        document?.constraints.length
          ? 'How fast each of several methods lowers the energy'
          : 'Add a constraint first: without one there is nothing to compare',
    },
  ],
} satisfies Feature;
