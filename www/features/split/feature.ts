/** The split view: two pictures of the model instead of one. */

import { isDrawn } from '../../store/state.ts';
import { toggleSplit } from './split.ts';
import type { Feature } from '../../app/context.ts';

export default {
  commands: (app) => [
    {
      id: 'split',
      group: 'View',
      label: 'Split view: original and now, or two measures',
      keys: ['C'],
      action: () => toggleSplit(app),
      needsModel: true,
      enabled: (state) => Boolean(state.model?.faces) && isDrawn(state),
      pressed: ({ split }) => split !== null,
    },
  ],
} satisfies Feature;
