/**
 * The context menu of the view: right click, long press or menu key. It acts on the selection, to
 * which the element under the pointer has been added.
 */

import { areHandlesLocked } from '../../store/handles.ts';
import { isEnabled, perform } from '../../store/perform.ts';
import { byId, element } from '../../ui/dom.ts';
import { placeMenu } from '../../ui/controls/navigation.ts';
import { once } from '../../ui/once.ts';
import type { AppContext } from '../../app/context.ts';

/** The anchor of the menu, in CSS pixels of the page. */
let place = new DOMRect();

/** The only one of the page. */
const theMenu = once(() => {
  const menu = element('div.menu', {
    id: 'context-menu',
    popover: 'manual',
    role: 'menu',
    'aria-label': 'What is here',
  });
  byId('menus').append(menu);
  placeMenu(menu, () => ({ getBoundingClientRect: () => place }) as HTMLElement);
  // An automatic popover would close when the finger of the long press is lifted.
  const leave = (event: Event) => {
    if (!(event.target instanceof Node && menu.contains(event.target))) menu.hidePopover();
  };
  menu.addEventListener('toggle', (event) => {
    const isOpen = event.newState === 'open';
    const change = isOpen ? window.addEventListener : window.removeEventListener;
    for (const name of ['pointerdown', 'wheel', 'resize']) change(name, leave, true);
  });
  return menu;
});

/** @param at in CSS pixels of the page */
export function showContextMenu(at: [number, number], app: AppContext) {
  const { store, viewport, actions } = app;
  const menu = theMenu();
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
  function item(label: string, action: () => void): HTMLElement {
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

type Item = [label: string, action: () => void];

/** The available actions under their headings. */
function sectionsOf({
  store,
  actions,
  selecting,
  commands,
}: AppContext): [heading: string, items: Item[]][] {
  const state = store.get();
  const { document, operations } = state;
  const what = state.document?.undo || state.undoReplacing;
  const vertices = actions.selectedVertices();
  const held = new Map(document?.handles.map((handle) => [handle.vertex, handle.fixed]));
  const areFree = !areHandlesLocked(document);
  /** Whether a vertex that is held so may be held otherwise. */
  const some = (as: boolean | undefined) =>
    areFree && vertices.some((vertex) => held.get(vertex) === as);
  const offer: (fits: boolean, label: string, id: string) => [boolean, ...Item] = (
    fits,
    label,
    id,
  ) => {
    const command = commands.find((known) => known.id === id);
    if (!command) throw new Error(`no command is called ${id}`);
    return [fits && isEnabled(command, state), label, () => perform(command, store)];
  };
  const selections = operations
    .filter((operation) => operation.needsSelection && operation.params.length === 0)
    .filter((operation) => selecting.canApply(operation))
    .map((operation) => [operation.label, () => void selecting.applyOrReport(operation)] as Item);
  const sections: [string, [boolean, ...Item][]][] = [
    [
      'Handles',
      [
        [some(undefined), 'Make handle', () => actions.holdSelected(false)],
        [some(undefined) || some(false), 'Fix', () => actions.holdSelected(true)],
        [some(true), 'Make soft', () => actions.softenSelected()],
        offer(some(true) || some(false), 'Remove handle', 'remove-handles'),
      ],
    ],
    ['Constraints', [offer(true, 'Add constraint', 'add-constraint')]],
    ['Mesh', [offer(true, 'Edit mesh', 'edit-mesh')]],
    [
      'Selection',
      [
        ...selections.map((item) => [true, ...item] as [boolean, ...Item]),
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
    ['Edit', [offer(what !== '', `Undo: ${what}`, 'undo')]],
  ];
  return sections
    .map(
      ([heading, items]) =>
        [heading, items.filter(([fits]) => fits).map(([, label, action]) => [label, action])] as [
          string,
          Item[],
        ],
    )
    .filter(([, items]) => items.length > 0);
}
