/**
 * The context menu of the view: right click, long press or menu key. It acts on the selection, to
 * which the element under the pointer has been added. Loaded on first use.
 */

import { isEnabled, press } from '../../store/press.js';
import { byId, element } from '../../ui/dom.js';
import { placeMenu } from '../../ui/controls/menu.js';

/** The anchor of the menu, in CSS pixels of the page. */
let place = new DOMRect();

const menu = element('div.menu', {
  id: 'context-menu',
  popover: 'manual',
  role: 'menu',
  'aria-label': 'What is here',
});
byId('menus').append(menu);
placeMenu(menu, () => /** @type {HTMLElement} */ ({ getBoundingClientRect: () => place }));
// An automatic popover would close when the finger of the long press is lifted.
const leave = (/** @type {Event} */ event) => {
  if (!(event.target instanceof Node && menu.contains(event.target))) menu.hidePopover();
};
menu.addEventListener('toggle', (event) => {
  const isOpen = /** @type {ToggleEvent} */ (event).newState === 'open';
  const change = isOpen ? window.addEventListener : window.removeEventListener;
  for (const name of ['pointerdown', 'wheel', 'resize']) change(name, leave, true);
});

/**
 * @param {[number, number]} at in CSS pixels of the page
 * @param {import("../../app/context.js").AppContext} app
 */
export function showContextMenu(at, app) {
  const { store, viewport, actions } = app;
  place = new DOMRect(...at, 0, 0);
  menu.replaceChildren(
    ...sectionsOf(app).map(([heading, items]) =>
      element(
        'div.section',
        { role: 'group', 'aria-label': heading },
        element('p.heading.quiet', { 'aria-hidden': 'true' }, heading),
        ...items.map(([label, action]) => item(label, action)),
      ),
    ),
  );
  /** @type {(label: string, action: () => void) => HTMLElement} */
  function item(label, action) {
    const onclick = () => {
      close();
      action();
    };
    return element('button', { role: 'menuitem', onclick }, label);
  }
  const close = () => {
    menu.hidePopover();
    viewport.element.focus({ preventScroll: true });
  };
  menu.onkeydown = (event) => {
    if (event.key !== 'Escape' && event.key !== 'Tab') return;
    event.preventDefault();
    event.stopPropagation();
    close();
  };
  if (store.get().model) menu.showPopover();
  else actions.setStatus('Nothing is open yet');
}

/** @typedef {[label: string, action: () => void]} Item */

/**
 * The available actions under their headings.
 * @param {import("../../app/context.js").AppContext} app
 * @returns {[heading: string, items: Item[]][]}
 */
function sectionsOf({ store, actions, selecting, commands }) {
  const state = store.get();
  const { document, operations } = state;
  const vertices = actions.selectedVertices();
  const held = new Map(document?.handles.map((handle) => [handle.vertex, handle.fixed]));
  const some = (/** @type {boolean | undefined} */ as) =>
    vertices.some((vertex) => held.get(vertex) === as);
  /** @type {(fits: boolean, label: string, id: string) => [boolean, ...Item]} */
  const offer = (fits, label, id) => {
    const command = commands.find((known) => known.id === id);
    if (!command) throw new Error(`no command is called ${id}`);
    return [fits && isEnabled(command, state), label, () => press(command, store)];
  };
  const selections = operations
    .filter((operation) => operation.needsSelection && operation.params.length === 0)
    .filter((operation) => selecting.canApply(operation))
    .map(
      (operation) =>
        /** @type {Item} */ ([operation.label, () => void selecting.applyOrReport(operation)]),
    );
  /** @type {[string, [boolean, ...Item][]][]} */
  const sections = [
    [
      'Handles',
      [
        [some(undefined), 'Make handle', () => actions.addHandles(vertices, false)],
        [some(undefined) || some(false), 'Fix here', () => actions.addHandles(vertices, true)],
        [some(true), 'Make movable', () => actions.addHandles(vertices, false)],
        offer(some(true) || some(false), 'Release handle', 'remove-handles'),
      ],
    ],
    ['Constraints', [offer(true, 'Add constraint', 'add-constraint')]],
    ['Mesh', [offer(true, 'Edit mesh', 'edit-mesh')]],
    [
      'Selection',
      [
        ...selections.map((item) => /** @type {[boolean, ...Item]} */ ([true, ...item])),
        [vertices.length > 0, 'Clear selection', actions.selectNothing],
      ],
    ],
    [
      'View',
      [
        offer(vertices.length > 0, 'Zoom to selection', 'fit-selection'),
        offer(vertices.length === 0, 'Zoom to everything', 'fit-all'),
      ],
    ],
    ['Edit', [offer(Boolean(document?.undo), `Undo: ${document?.undo}`, 'undo')]],
  ];
  return sections
    .map(
      ([heading, items]) =>
        /** @type {[string, Item[]]} */ ([
          heading,
          items.filter(([fits]) => fits).map(([, label, action]) => [label, action]),
        ]),
    )
    .filter(([, items]) => items.length > 0);
}
