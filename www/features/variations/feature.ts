/** Variations: other shapes that are equally exact. Loaded on first use. */

import type { Feature } from '../../app/context.ts';

export default {
  parts: [
    {
      keys: ['numbers'],
      isNeeded: ({ numbers }) => Boolean(numbers?.exact),
      load: (app) => import('./entry.ts').then((it) => it.offerVariations(app)),
    },
  ],
} satisfies Feature;
