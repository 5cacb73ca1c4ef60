/** The page as an embedded view, with `?embed` in its address. */

import { isEmbedded } from '../../ui/embedded.ts';
import type { Feature } from '../../app/context.ts';

export default {
  parts: [
    {
      keys: ['renderer'],
      isNeeded: () => isEmbedded,
      load: (app) => import('./embedded-view.ts').then((it) => it.embeddedView(app)),
    },
  ],
} satisfies Feature;
