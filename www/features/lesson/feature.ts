/** Lessons: the dialog for writing one, and the panel for the lesson of the scene. */

import type { Feature } from '../../app/context.ts';

export default {
  commands: (app) => [
    {
      id: 'lesson',
      group: 'File',
      label: 'Write a lesson: a text, and goals that are checked',
      keys: [],
      action: () => import('./dialog.ts').then((it) => it.write(app)),
      needsModel: true,
    },
  ],
  parts: [
    {
      keys: ['document'],
      isNeeded: ({ document }) => Boolean(document?.lesson),
      load: (app) => import('./panel.ts').then((it) => it.lessonPanel(app)),
    },
  ],
} satisfies Feature;
