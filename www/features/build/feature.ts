/** Sheets of parts, and the check whether they can be built. Loaded on first use. */

import type { Feature } from '../../app/context.ts';

export default {
  commands: (app) => [
    {
      id: 'build',
      group: 'File',
      label: 'Parts on sheets',
      keys: [],
      action: () => import('./build-panel.ts').then((it) => it.toggleBuild(app)),
      needsModel: true,
      pressed: ({ build }) => build !== null,
    },
  ],
  parts: [
    {
      keys: ['document'],
      isNeeded: ({ document }) => Boolean(document?.lesson?.goals.some(({ build }) => build)),
      load: (app) =>
        import('./build-goals.ts').then((it) => app.actions.reportErrors(it.buildGoals(app))),
    },
  ],
} satisfies Feature;
