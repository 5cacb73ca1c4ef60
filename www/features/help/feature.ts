/** The help: the actions of keys and mouse. */

import { byId } from '../../ui/dom.ts';
import type { Feature } from '../../app/context.ts';

export default {
  commands: (app) => [
    {
      id: 'help',
      group: 'Page',
      label: 'This list',
      keys: ['?', 'F1'],
      // The list of commands is read when opened, when it is complete.
      action: () => import('./help.ts').then((it) => it.showHelp(byId('help'), app.commands)),
      title: () => 'Mouse and keys',
    },
  ],
} satisfies Feature;
