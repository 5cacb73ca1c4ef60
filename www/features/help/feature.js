/** The help: what keys and the mouse do. */

import { byId } from '../../ui/dom.js';

/** @type {import("../../app/context.js").Feature} */
export default {
  commands: (app) => [
    {
      id: 'help',
      group: 'Page',
      label: 'This list',
      keys: ['?', 'F1'],
      // What it lists is complete by the time that somebody looks.
      action: () =>
        app.actions.reportErrors(
          import('./help.js').then((it) => it.showHelp(byId('help'), app.commands)),
        ),
      title: () => 'Mouse and keys',
    },
  ],
};
