/** Messages about a shape: the verdict on a run, and vertices that no constraint moves. */

import type { Feature } from '../../app/context.ts';

export default {
  parts: [
    {
      keys: ['fileName'],
      isNeeded: ({ fileName }) => fileName !== '',
      load: (app) => import('./warnings.ts').then((it) => it.watchConditions(app)),
    },
    {
      keys: ['document'],
      isNeeded: ({ document }) => Boolean(document?.constraints.some(({ paired }) => paired)),
      load: (app) => import('./unpaired.ts').then((it) => it.watchUnpaired(app)),
    },
    {
      keys: ['document'],
      isNeeded: ({ document }) => Boolean(document?.free && document.constraints.length > 0),
      load: (app) => import('./free-vertices.ts').then((it) => it.watchFreeVertices(app)),
    },
  ],
} satisfies Feature;
