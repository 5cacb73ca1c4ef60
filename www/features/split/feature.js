/** The split view: two pictures of the model instead of one. */

import { isDrawn } from '../../store/state.js';
import { toggleSplit } from './split.js';

/** @type {import("../../app/context.js").Feature} */
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
};
