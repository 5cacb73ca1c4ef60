/** Presentations: the steps of the scene, and showing them one after the other on the whole screen. */

import { byId } from '../../ui/dom.js';

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: (app) => [
    {
      id: 'present',
      group: 'View',
      label: 'Present: steps of views on the whole screen',
      keys: [],
      needsModel: true,
      action: () =>
        app.actions.reportErrors(import('./steps-dialog.js').then((it) => it.openSteps(app))),
    },
  ],
  parts: [
    {
      keys: ['document'],
      isNeeded: ({ document: scene }) => Boolean(scene?.steps.length),
      // Who is sent a presentation finds it.
      load: async () => byId('present-button').classList.remove('advanced'),
    },
  ],
};
