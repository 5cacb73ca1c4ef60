/** A new mesh from a kind and its sizes. */

import type { Feature } from '../../app/context.ts';

export default {
  commands: (app) => [
    {
      id: 'new-mesh',
      group: 'File',
      label: 'New mesh',
      keys: [],
      action: () => import('./dialog-new-mesh.ts').then((it) => it.newMesh(app)),
    },
  ],
} satisfies Feature;
