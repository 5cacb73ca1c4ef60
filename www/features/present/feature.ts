/** Presentations: defining the steps of a scene and showing them full screen. */

import { byId } from '../../ui/dom.ts';
import type { Feature } from '../../app/context.ts';

export default {
  commands: (app) => [
    {
      id: 'present',
      group: 'View',
      label: 'Present: a full-screen sequence of views',
      keys: [],
      needsModel: true,
      action: () => import('./steps-dialog.ts').then((it) => it.openSteps(app)),
    },
  ],
  parts: [
    {
      keys: ['document'],
      isNeeded: ({ document: scene }) => Boolean(scene?.steps.length),
      // The button is always shown for a scene with steps.
      load: async () => byId('present-button').classList.remove('advanced'),
    },
  ],
} satisfies Feature;
