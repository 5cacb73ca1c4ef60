/** Lessons: the dialog for writing one, and the panel for the lesson of the scene. */

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: (app) => [
    {
      id: 'lesson',
      group: 'File',
      label: 'Write a lesson: a text, and goals that are checked',
      keys: [],
      action: () => import('./dialog.js').then((it) => it.write(app)),
      needsModel: true,
    },
  ],
  parts: [
    {
      keys: ['document'],
      isNeeded: ({ document }) => Boolean(document?.lesson),
      load: (app) => import('./panel.js').then((it) => it.lessonPanel(app)),
    },
  ],
};
