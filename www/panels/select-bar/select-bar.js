/**
 * The selection bar over the view: shape of the drag, selecting through the surface, and the menu
 * of other operations. Shown while the Select tool is active, or something is selected.
 */

import './select-bar.css';
import { closeButton } from '../../ui/controls/fields.js';
import { element, icon, setText } from '../../ui/dom.js';
import { placeMenu } from '../../ui/controls/menu.js';
import { messageOf } from '../../solver/messages.js';
import { describe, sizeOfSelection } from '../../store/selection.js';

/** @typedef {import("../../store/state.js").State["shape"]} Shape */

/** @type {{ id: Shape, label: string, key: string, title: string }[]} */
const SHAPES = [
  {
    id: 'box',
    label: 'Box',
    key: 'B',
    title: 'Drag right to select what is inside, left to select also what it touches',
  },
  { id: 'lasso', label: 'Lasso', key: 'L', title: 'Draw around what to select' },
  { id: 'paint', label: 'Paint', key: 'P', title: 'Brush over what to select' },
];

/**
 * @param {HTMLElement} bar
 * @param {HTMLElement} menu
 * @param {import("../../app/context.js").AppContext} app
 */
export function selectBar(bar, menu, { store, actions, selecting, alerts }) {
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
  /**
   * The module of the menu, loaded on first use. @type {typeof import("./select-menu.js") | null}
   */
  let contents = null;
  menu.addEventListener('beforetoggle', async (event) => {
    if (/** @type {ToggleEvent} */ (event).newState !== 'open') return;
    if (contents) return contents.fillSelectMenu(menu, store, actions, selecting);
    event.preventDefault();
    try {
      contents = await import('./select-menu.js');
      menu.showPopover();
    } catch (error) {
      alerts.error(messageOf(error));
    }
  });
}
