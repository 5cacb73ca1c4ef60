/**
 * The selection bar over the view: shape of the drag, selecting through the surface, and the menu
 * of other operations. Shown while the Select tool is active, or something is selected.
 */

import './select-bar.css';
import { closeButton } from '../../ui/controls/fields.ts';
import { element, icon, setText } from '../../ui/dom.ts';
import { placeMenu } from '../../ui/controls/navigation.ts';
import { describe, sizeOfSelection } from '../../store/selection.ts';
import { fillSelectMenu } from './select-menu.ts';
import type { State } from '../../store/state.ts';
import type { AppContext } from '../../app/context.ts';

type Shape = State['shape'];

const SHAPES: { id: Shape; label: string; key: string; title: string }[] = [
  {
    id: 'box',
    label: 'Box',
    key: 'B',
    title: 'Drag right to select what is inside, left to select also what it touches',
  },
  { id: 'lasso', label: 'Lasso', key: 'L', title: 'Draw around what to select' },
  { id: 'paint', label: 'Paint', key: 'P', title: 'Brush over what to select' },
];

export function selectBar(
  bar: HTMLElement,
  menu: HTMLElement,
  { store, actions, selecting }: AppContext,
) {
  const shapes = SHAPES.map(({ id, label, key, title }) =>
    element(
      'button',
      { title: `${title} (${key})`, onclick: () => actions.useTool({ tool: 'select', shape: id }) },
      icon(id),
      element('span', label),
    ),
  );
  const through = element(
    'button.toggle',
    {
      title: 'Also select what the surface hides (T)',
      onclick: () => actions.useTool({ through: !store.get().through }),
    },
    icon('through'),
    element('span', 'Select through'),
  );
  const brush = element('input', {
    type: 'range',
    min: '4',
    max: '120',
    step: '2',
    'aria-label': 'Brush radius',
    title: 'Brush radius ([ and ])',
    oninput: () => actions.useTool({ brush: brush.valueAsNumber }),
  });
  const selectionText = element('span.said');
  const opener = element(
    'button.bordered',
    { popovertarget: menu.id, 'aria-haspopup': 'dialog' },
    selectionText,
    icon('chevron'),
  );
  const none = closeButton('Clear', actions.selectNothing, {
    class: 'square',
    title: 'Clear the selection (Esc)',
  });
  bar.append(
    element('div.segmented', { role: 'group', 'aria-label': 'Shape of the selection' }, ...shapes),
    through,
    brush,
    opener,
    none,
  );

  store.subscribe(['tool', 'shape', 'through', 'brush', 'selection', 'model'], (state) => {
    const { tool, shape, selection, model } = state;
    const some = sizeOfSelection(selection) > 0;
    bar.hidden = !model || (tool !== 'select' && !some);
    shapes.forEach((button, i) => {
      const pressed = tool === 'select' && SHAPES[i].id === shape;
      button.setAttribute('aria-pressed', String(pressed));
    });
    through.setAttribute('aria-pressed', String(state.through));
    through.hidden = tool !== 'select';
    brush.hidden = tool !== 'select' || shape !== 'paint';
    brush.value = String(state.brush);
    brush.setAttribute('aria-valuetext', `${state.brush} pixels`);
    const words = describe(selection);
    setText(selectionText, words || 'Select by…');
    opener.setAttribute('aria-label', words ? `${words}: select by…` : 'Select by…');
    none.hidden = !some;
  });

  placeMenu(menu, () => opener);
  menu.addEventListener('beforetoggle', ({ newState }) => {
    if (newState === 'open') fillSelectMenu(menu, store, actions, selecting);
  });
}
