/** A link to the scene. */

import type { Feature } from '../../app/context.ts';

export default {
  commands: (app) => [
    {
      id: 'share',
      group: 'File',
      label: 'Share a link to the scene',
      keys: [],
      action: () => import('./dialog-share.ts').then((it) => it.share(app)),
      needsModel: true,
    },
  ],
} satisfies Feature;
