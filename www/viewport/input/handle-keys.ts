/**
 * Moves handles by keys while the view has the focus: Enter grabs the selected handles, arrow keys
 * move them on the screen (with Shift at constant height), X, Y and Z restrict them to an axis,
 * Enter drops them, Escape puts them back.
 */

import { HANDLES_LOCKED, areHandlesLocked, type ViewDrag } from '../../store/handles.ts';
import { ARROWS } from '../../ui/keys.ts';
import type { Viewport } from '../viewport.ts';
import type { Store } from '../../store/state.ts';
import type { Actions } from '../../store/actions.ts';

/** Step of an arrow key, in CSS pixels. */
const STEP = 8;
const AXES = ['x', 'y', 'z'];

/** Must be bound before the view's keys, which use the arrows otherwise. */
export function bindHandleKeys(viewport: Viewport, store: Store, actions: Actions) {
  const { element } = viewport;
  let drag: ViewDrag | null = null;
  let at = [0, 0];

  function grab() {
    const [vertex] = actions.selectedHandles();
    if (vertex === undefined || !viewport.view || store.get().dragged.length > 0) return false;
    if (areHandlesLocked(store.get().document)) {
      actions.setStatus(HANDLES_LOCKED);
      return false;
    }
    viewport.view.holdVertex(vertex);
    drag = actions.drags.hold(viewport.constrainMove, vertex);
    at = [0, 0];
    actions.setStatus('Moving the handle with the arrow keys: Enter accepts, Esc cancels');
    return true;
  }

  function release(keep: boolean) {
    const hasMoved = keep && drag?.end();
    if (!keep) drag?.cancel();
    drag = null;
    const kept = hasMoved ? 'Handle moved' : 'The handle stays where it was';
    actions.setStatus(keep ? kept : 'Move cancelled');
    return true;
  }

  /** Handles a key; returns whether it applied to a handle. */
  function press({ key, shiftKey, repeat }: KeyboardEvent) {
    if (drag?.isOver) drag = null;
    if (!drag) return key === 'Enter' && !repeat && grab();
    const axis = AXES.indexOf(key.toLowerCase());
    const arrow = ARROWS[key];
    const ends = key === 'Enter' || key === 'Escape';
    // A key that is held moves on, and switches nothing to and fro.
    if (repeat && !arrow) return ends || axis >= 0;
    if (ends) return release(key === 'Enter');
    if (axis >= 0) drag.toggleAxis(axis);
    if (arrow) {
      at = [at[0] + STEP * arrow[0], at[1] + STEP * arrow[1]];
      drag.setPlane(shiftKey ? 'horizontal' : 'screen');
      drag.move(at[0], at[1]);
    }
    return axis >= 0 || arrow !== undefined;
  }

  element.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !press(event)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
  });
  element.addEventListener('blur', () => {
    if (drag && !drag.isOver) release(true);
  });
}
