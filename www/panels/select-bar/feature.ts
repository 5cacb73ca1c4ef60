/** The selection bar: shown while the Select tool is active, or something is selected. */

import { sizeOfSelection } from '../../store/selection.ts';
import { byId } from '../../ui/dom.ts';
import type { Feature } from '../../app/context.ts';

export default {
  parts: [
    {
      keys: ['tool', 'selection'],
      isNeeded: ({ tool, selection }) => tool === 'select' || sizeOfSelection(selection) > 0,
      load: (app) =>
        import('./select-bar.ts').then((it) =>
          it.selectBar(byId('select-bar'), byId('select-menu'), app),
        ),
    },
  ],
} satisfies Feature;
