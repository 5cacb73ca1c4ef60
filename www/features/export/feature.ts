/** Export in formats other than OBJ. */

import type { Feature } from '../../app/context.ts';

export default {
  commands: (app) => [
    {
      id: 'export-as',
      group: 'File',
      label: 'More formats: Rhino, tables, pictures',
      keys: ['Ctrl+Shift+E'],
      action: () => import('./dialog-export.ts').then((it) => it.showExport(app)),
      needsModel: true,
    },
  ],
} satisfies Feature;
