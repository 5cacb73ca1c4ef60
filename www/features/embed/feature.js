/** The page as an embedded view, with `?embed` in its address. */

import { isEmbedded } from '../../ui/embedded.js';

/** @type {import("../../app/context.js").Feature} */
export default {
  parts: [
    {
      keys: ['renderer'],
      isNeeded: () => isEmbedded,
      load: (app) => import('./embedded-view.js').then((it) => it.embeddedView(app)),
    },
  ],
};
