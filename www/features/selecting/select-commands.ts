/** The commands of the Select tool: box, lasso and brush, and selecting hidden elements. */

import { resizedBrush } from '../../store/selection.ts';
import type { AppContext, Command } from '../../app/context.ts';
import type { State } from '../../store/state.ts';

/** Factor of the brush keys. */
const BRUSH_FACTOR = 1.25;

export function selectCommands({ store, actions }: AppContext): Command[] {
  const shape = (id: State['shape'], label: string, key: string, title: string) => ({
    id: `shape-${id}`,
    group: 'Select',
    label,
    keys: [key],
    action: () => actions.look({ tool: 'select', shape: id }),
    pressed: ({ tool, shape }: State) => tool === 'select' && shape === id,
    title: () => title,
  });
  const brush = (id: string, label: string, key: string, factor: number) => ({
    id,
    group: 'Select',
    label,
    keys: [key],
    repeats: true,
    action: () => actions.look({ brush: resizedBrush(store.get().brush, factor) }),
  });
  return [
    shape(
      ...(['box', 'Select with a box', 'B'] as const),
      'Drag right to select what is inside, left to select also what it touches',
    ),
    shape('lasso', 'Select with a lasso', 'L', 'Draw around what to select'),
    shape('paint', 'Select with a brush', 'P', 'Brush over what to select'),
    brush('brush-smaller', 'Smaller brush', '[', 1 / BRUSH_FACTOR),
    brush('brush-larger', 'Larger brush', ']', BRUSH_FACTOR),
    {
      id: 'through',
      group: 'Select',
      label: 'Also select hidden elements',
      keys: ['T'],
      action: () => actions.look({ through: !store.get().through }),
      pressed: ({ through }) => through,
      title: () => 'Also select what the surface hides',
    },
  ];
}
