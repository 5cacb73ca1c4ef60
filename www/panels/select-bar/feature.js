/** The selection bar: shown while the Select tool is active, or something is selected. */

import { sizeOfSelection } from '../../store/selection.js';
import { byId } from '../../ui/dom.js';

/** @type {import("../../app/context.js").Feature} */
export default {
  parts: [
    {
      keys: ['tool', 'selection'],
      isNeeded: ({ tool, selection }) => tool === 'select' || sizeOfSelection(selection) > 0,
      load: (app) =>
        import('./select-bar.js').then((it) =>
          it.selectBar(byId('select-bar'), byId('select-menu'), app),
        ),
    },
  ],
};
