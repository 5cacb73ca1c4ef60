/**
 * The context menu of the view: right click, long press or menu key. It acts on the selection, to
 * which the element under the pointer has been added.
 */

import { signal } from '@preact/signals';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { areHandlesLocked } from '../../store/handles.ts';
import { isEnabled, perform } from '../../store/perform.ts';
import { useApp } from '../../store/use-app.ts';
import { Menu } from '../../ui/components/menu.tsx';
import type { AppContext } from '../../app/context.ts';

/** Where it was asked for, in CSS pixels of the page; null while it is closed. */
const asked = signal<[number, number] | null>(null);

/** @param at in CSS pixels of the page */
export const showContextMenu = (at: [number, number]) => (asked.value = at);

export function ContextMenu() {
  const app = useApp();
  const menu = useRef<HTMLDivElement>(null);
  const at = asked.value;
  useLayoutEffect(() => {
    const place = menu.current;
    if (!at || !place) return;
    if (!app.store.get().model) return app.actions.setStatus('Nothing is open yet');
    place.showPopover();
    // An automatic popover would close when the finger of the long press is lifted.
    const leave = ({ target }: Event) => {
      if (!(target instanceof Node && place.contains(target))) place.hidePopover();
    };
    const names = ['pointerdown', 'wheel', 'resize'];
    for (const name of names) window.addEventListener(name, leave, true);
    return () => names.forEach((name) => window.removeEventListener(name, leave, true));
  }, [at]);
  const close = () => {
    menu.current?.hidePopover();
    app.viewport.element.focus({ preventScroll: true });
  };
  return (
    <Menu
      of={menu}
      anchor={() => ({ getBoundingClientRect: () => new DOMRect(...(at ?? []), 0, 0) })}
      id="context-menu"
      popover="manual"
      role="menu"
      aria-label="What is here"
      onToggle={({ newState }) => {
        if (newState === 'closed' && asked.value === at) asked.value = null;
      }}
      onKeyDown={(event) => {
        if (event.key !== 'Escape' && event.key !== 'Tab') return;
        event.preventDefault();
        event.stopPropagation();
        close();
      }}
    >
      {at &&
        sectionsOf(app).map(([heading, items]) => (
          <div key={heading} class="section" role="group" aria-label={heading}>
            <p class="heading quiet" aria-hidden="true">
              {heading}
            </p>
            {items.map(([label, action]) => (
              <button
                key={label}
                type="button"
                role="menuitem"
                onClick={() => {
                  close();
                  action();
                }}
              >
                {label}
              </button>
            ))}
          </div>
        ))}
    </Menu>
  );
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
