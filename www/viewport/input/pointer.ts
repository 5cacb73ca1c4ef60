/**
 * Mouse, pen and touch on the viewport.
 *
 * | | Drag tool | Select tool |
 * |---|---|---|
 * | left on a handle | moves it | moves it |
 * | left on the gizmo | moves the selected handles along an axis or in a plane | same |
 * | left elsewhere, drag | orbits; Shift + left beside the model pans | box, lasso or brush: see `region-selection.ts` |
 * | Alt + left on a vertex | makes it a handle and moves it | same |
 * | left click | selects; Shift adds, Ctrl (on a Mac Cmd) removes | same |
 * | Alt + left click on an edge | selects its loop, as a double-click | same |
 * | double-click | vertex: handle; edge: loop; face: flat patch; nothing: fit all | same |
 * | right, middle | orbit, pan, zoom: see `mouse.ts` | same |
 * | wheel, pinch | zooms to the cursor | same |
 * | right click, on a Mac Ctrl + click, long press | opens the context menu of the element hit | same |
 * | touch | one finger as left, the button that adds as Shift; two pan and zoom | same |
 */

import { HANDLES_LOCKED, areHandlesLocked, type ViewDrag } from '../../store/handles.ts';
import { near, clickTolerance, pair, wheelFactor } from './gestures.ts';
import { combineOf, select } from '../../store/selection.ts';
import { IS_MAC } from '../../ui/keys.ts';
import { cameraDrag, type CameraDrag } from './mouse.ts';
import type { Mode, Store } from '../../store/state.ts';
import type { SolverClient } from '../../solver/solver-client.ts';
import type { Viewport } from '../viewport.ts';
import type { RegionSelection } from './region-selection.ts';
import type { Actions } from '../../store/actions.ts';

/** Radius in CSS pixels within which a handle takes precedence over a gizmo part on top of it. */
const ON_HANDLE = 9;
/** Radii in CSS pixels of a double-click: it hits a vertex, else an edge, else the face. */
const ON_VERTEX = 8;
const ON_EDGE = 5;
/** How much a drag by one pixel zooms, as the logarithm of the factor. */
const ZOOM_PER_PIXEL = 0.01;
/** Duration of a long press with a finger, in milliseconds. */
const LONG_PRESS_MS = 500;

/** State of a press until it is released. */
type Gesture =
  | { kind: 'press' | CameraDrag | 'region' | 'pinch' | 'spent' }
  | { kind: 'handle'; drag: ViewDrag };

export class PointerInput {
  #store;
  #viewport;
  #element;
  #region;
  #actions;
  #commands;
  /** Last position of each pressed pointer. */
  #down: Map<number, [number, number]> = new Map();
  /** Position of the element on the page. */
  #corner = [0, 0];
  #start: [number, number] = [0, 0];
  /** The pressed handle. */
  #handle: number | undefined;
  /** The pressed part of the gizmo. */
  #gizmoPart: string | undefined;
  /** Whether the right button is pressed. */
  #isRight = false;
  /** Timer of a long press. */
  #longPressTimer = 0;
  #gesture: Gesture | null = null;

  constructor(
    store: Store,
    solver: SolverClient,
    viewport: Viewport,
    region: RegionSelection,
    actions: Actions,
    commands: {
      showMenu: (at: [number, number]) => void;
      doubleClick: (mode: Mode, item: number, event: MouseEvent) => void;
    },
  ) {
    this.#store = store;
    this.#viewport = viewport;
    this.#element = viewport.element;
    this.#region = region;
    this.#actions = actions;
    this.#commands = commands;
    const listen: HTMLElement['addEventListener'] = this.#element.addEventListener.bind(
      this.#element,
    );
    listen('pointerdown', (event) => this.#press(event));
    listen('pointermove', (event) => this.#move(event));
    listen('pointerup', (event) => this.#release(event));
    listen('pointercancel', (event) => {
      if (this.#down.delete(event.pointerId)) this.cancel();
    });
    // What was begun on another mesh has nothing to restore on this one.
    solver.on('model', () => {
      if (this.#gesture?.kind !== 'region') return;
      this.#region.hide();
      this.#become({ kind: 'spent' });
    });
    listen('pointerleave', () => actions.look({ gizmoPart: undefined, pointedAt: undefined }));
    listen('dblclick', (event) => this.#doubleClick(event));
    listen('wheel', (event) => this.#wheel(event), { passive: false });
    listen('contextmenu', (event) => event.preventDefault());
    listen('keydown', (event) => this.#menuKey(event));
    window.addEventListener('keydown', (event) => this.#keyWhileDown(event), { capture: true });
    store.subscribe(['tool'], ({ tool }) => (this.#element.dataset.tool = tool));
    store.subscribe(['tape'], ({ tape }) =>
      this.#element.toggleAttribute('data-measures', tape !== null),
    );
  }

  /** Cancels the gesture and undoes its effect. Returns whether there was one. */
  cancel() {
    const gesture = this.#gesture;
    if (!gesture) return false;
    if (gesture.kind === 'handle') gesture.drag.cancel();
    if (gesture.kind === 'region') this.#region.cancel();
    this.#become(this.#down.size > 0 ? { kind: 'spent' } : null);
    return true;
  }

  #at(event: MouseEvent): [number, number] {
    // Measure only if nothing is pressed: during a drag it would force two layouts per frame.
    if (this.#down.size === 0) {
      const { left, top } = this.#element.getBoundingClientRect();
      this.#corner = [left, top];
    }
    return [event.clientX - this.#corner[0], event.clientY - this.#corner[1]];
  }

  #press(event: PointerEvent) {
    // A second finger or a palm while a handle is dragged has no part in it.
    if (!this.#viewport.view || this.#gesture?.kind === 'handle') return;
    const at = this.#at(event);
    this.#element.focus({ preventScroll: true });
    this.#element.setPointerCapture(event.pointerId);
    this.#down.set(event.pointerId, at);
    if (this.#down.size > 1) return this.#secondFinger();
    this.#start = at;
    this.#handle = undefined;
    this.#isRight = isRight(event);
    if (event.button === 1) {
      event.preventDefault();
      this.#moveCamera(1, event);
    } else if (this.#isRight) {
      this.#aim(event, at);
      this.#become({ kind: 'press' });
    } else if (event.button === 0) {
      this.#aim(event, at);
      if (event.altKey && this.#handle === undefined) return this.#makeHandle(at);
      const paints = this.#handle === undefined && this.#region.paints;
      this.#become({ kind: paints ? 'region' : 'press' });
      if (paints) this.#region.begin(at, this.#combineOf(event));
      else if (event.pointerType === 'touch')
        this.#longPressTimer = window.setTimeout(() => this.#longPress(event, at), LONG_PRESS_MS);
    }
  }

  /** Opens the menu after a long press, unless a pending event ends the press in this frame. */
  #longPress(event: PointerEvent, at: [number, number]) {
    const gesture = this.#gesture;
    requestAnimationFrame(() => {
      if (gesture?.kind === 'press' && gesture === this.#gesture) this.#openMenu(event, at);
    });
  }

  /** Shows the context menu of the element hit, after selecting it. */
  #openMenu(event: PointerEvent, at: [number, number]) {
    const { mode, selection, adds } = this.#store.get();
    const what = this.#handle === undefined ? mode : 'vertices';
    const item = this.#handle ?? this.#pick(mode, event, at);
    if (item !== undefined && !selection[what].has(item))
      this.#actions.look({ selection: select(selection, what, [item], adds ? 'add' : 'replace') });
    this.#become({ kind: 'spent' });
    this.#commands.showMenu([event.clientX, event.clientY]);
  }

  #menuKey(event: KeyboardEvent) {
    if (event.key !== 'ContextMenu' && !(event.key === 'F10' && event.shiftKey)) return;
    event.preventDefault();
    const { left, top, width, height } = this.#element.getBoundingClientRect();
    this.#commands.showMenu([left + width / 2, top + height / 2]);
  }

  /** Finds the handle under the pointer, or the gizmo part and a handle that it moves. */
  #aim(event: PointerEvent, at: [number, number]) {
    this.#gizmoPart = this.#viewport.with((view) => view.pickGizmo(...at));
    this.#handle = this.#handleAt(at, this.#gizmoPart ? ON_HANDLE : near(event));
    if (this.#handle !== undefined) this.#gizmoPart = undefined;
    else if (this.#gizmoPart) [this.#handle] = this.#actions.selectedHandles();
  }

  /** Makes the vertex under the pointer a handle and drags it, as one step of undo. */
  #makeHandle(at: [number, number]) {
    // As near as for a double-click: on an edge, a click with Alt selects its loop.
    const found = this.#viewport.with((view) => view.pickVertex(...at, ON_VERTEX));
    if (found === undefined || this.#isLocked(found)) return this.#become({ kind: 'press' });
    this.#viewport.view?.holdVertex(found, ...at);
    const drag = this.#actions.drags.make(this.#viewport.constrainMove, found);
    this.#become({ kind: 'handle', drag });
  }

  #drag(event: PointerEvent, at: [number, number]) {
    if (this.#gesture?.kind !== 'handle') return;
    const [dx, dy] = [at[0] - this.#start[0], at[1] - this.#start[1]];
    this.#gesture.drag.move(dx, dy, event.timeStamp);
  }

  /**
   * Toggles a restriction of the dragged handle to an axis by X, Y or Z. Escape cancels the
   * gesture, with any modifier.
   */
  #keyWhileDown(event: KeyboardEvent) {
    const isChord = event.ctrlKey || event.metaKey;
    const axis = isChord ? -1 : ['x', 'y', 'z'].indexOf(event.key.toLowerCase());
    if (axis >= 0 && this.#gesture?.kind === 'handle') {
      if (!event.repeat) this.#gesture.drag.toggleAxis(axis);
    } else if (event.key !== 'Escape' || !this.cancel()) return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** A second finger switches to pan and zoom. What the first one has done meanwhile was not meant. */
  #secondFinger() {
    this.cancel();
    this.#become({ kind: 'pinch' });
  }

  #move(event: PointerEvent) {
    const at = this.#at(event);
    const last = this.#down.get(event.pointerId);
    if (!last) return this.#hover(event, at);
    if (this.#gesture?.kind === 'pinch') return this.#pinch(event.pointerId, at);
    this.#down.set(event.pointerId, at);
    if (this.#gesture?.kind === 'press') {
      const moved = Math.hypot(at[0] - this.#start[0], at[1] - this.#start[1]);
      if (moved < clickTolerance(event)) return;
      if (this.#isRight) this.#moveCamera(2, event);
      else this.#begin(event.shiftKey);
    }
    const [dx, dy] = [at[0] - last[0], at[1] - last[1]];
    switch (this.#gesture?.kind) {
      case 'handle':
        this.#gesture.drag.setPlane(planeOf(event));
        return this.#drag(event, at);
      case 'orbit':
        return void this.#viewport.with((view) => view.turn(dx, dy));
      case 'pan':
        return void this.#viewport.with((view) => view.pan(dx, dy));
      case 'zoom':
        return void this.#viewport.with((view) =>
          view.zoom(Math.exp(-ZOOM_PER_PIXEL * dy), ...this.#start),
        );
      case 'region':
        return this.#region.move(at);
    }
  }

  /** Starts what a drag with the middle (1) or right (2) button does to the camera. */
  #moveCamera(button: 1 | 2, event: PointerEvent) {
    const kind = cameraDrag(this.#store.get().mouse, button, event);
    if (kind === 'orbit') this.#beginTurn();
    else this.#become({ kind });
  }

  /**
   * Turns a press into a drag: of a handle, of the camera, or of a region.
   * @param withShift whether Shift is held
   */
  #begin(withShift: boolean) {
    const { constrainMove, view } = this.#viewport;
    const handle = this.#isLocked(this.#handle) ? undefined : this.#handle;
    const part = this.#gizmoPart;
    if (handle !== undefined && view) {
      if (part) view.holdGizmo(...this.#start);
      else view.holdVertex(handle, ...this.#start);
      const drag = this.#actions.drags.hold(constrainMove, handle, part);
      this.#become({ kind: 'handle', drag });
    } else {
      if (this.#store.get().tool !== 'select') {
        const isBeside = view?.pickFace(...this.#start) === undefined;
        return withShift && isBeside ? this.#become({ kind: 'pan' }) : this.#beginTurn();
      }
      this.#become({ kind: 'region' });
      this.#region.begin(this.#start, 'replace');
    }
  }

  /** Whether there is a handle that a lesson locks; says so. */
  #isLocked(handle: number | undefined) {
    const isLocked = handle !== undefined && areHandlesLocked(this.#store.get().document);
    if (isLocked) this.#actions.setStatus(HANDLES_LOCKED);
    return isLocked;
  }

  /** Starts turning the camera about the point that was pressed. */
  #beginTurn() {
    this.#viewport.with((view) => view.beginTurn(...this.#start));
    this.#become({ kind: 'orbit' });
  }

  #release(event: PointerEvent) {
    const at = this.#at(event);
    if (!this.#down.delete(event.pointerId)) return;
    const gesture = this.#gesture;
    switch (gesture?.kind) {
      case 'handle':
        this.#drag(event, at);
        gesture.drag.end();
        break;
      case 'press':
        if (this.#isRight) this.#openMenu(event, at);
        else this.#click(event, at);
        break;
      case 'region':
        this.#region.end(at, this.#combineOf(event));
        break;
    }
    this.#become(this.#down.size > 0 ? { kind: 'spent' } : null);
  }

  #click(event: PointerEvent, at: [number, number]) {
    if (this.#gizmoPart) return;
    const { mode, selection, tape } = this.#store.get();
    if (tape) {
      const end = this.#handle ?? this.#vertexAt(event, at);
      const isOther = tape.length === 1 && tape[0] !== end;
      if (end !== undefined) this.#actions.look({ tape: isOther ? [...tape, end] : [end] });
      return;
    }
    const combine = this.#combineOf(event);
    if (event.altKey && this.#handle === undefined) {
      const edge = this.#viewport.with((view) => view.pickEdge(...at, near(event)));
      if (edge !== undefined) return this.#commands.doubleClick('edges', edge, event);
    }
    const item = this.#handle ?? this.#pick(mode, event, at);
    if (item !== undefined) {
      const what = this.#handle === undefined ? mode : 'vertices';
      this.#actions.look({ selection: select(selection, what, [item], combine) });
    } else if (combine === 'replace') {
      this.#actions.selectNothing();
    }
  }

  #combineOf(event: MouseEvent) {
    return combineOf(event, this.#store.get().adds);
  }

  /** Picks the element under the pointer. */
  #pick(mode: Mode, event: MouseEvent, at: [number, number]) {
    if (mode === 'vertices') return this.#vertexAt(event, at);
    return this.#viewport.with((view) =>
      mode === 'edges' ? view.pickEdge(...at, near(event)) : view.pickFace(...at),
    );
  }

  /** Acts on the element hit, whatever the selection mode. */
  #doubleClick(event: MouseEvent) {
    const at = this.#at(event);
    if (this.#store.get().tape || this.#gizmoPart) return;
    this.#viewport.with((view) => {
      const vertex = view.pickVertex(...at, ON_VERTEX);
      if (vertex !== undefined) return void this.#actions.addHandles([vertex], false);
      const edge = view.pickEdge(...at, ON_EDGE);
      const face = view.pickFace(...at);
      if (edge !== undefined) this.#commands.doubleClick('edges', edge, event);
      else if (face !== undefined) this.#commands.doubleClick('faces', face, event);
      else this.#viewport.with((view) => view.fit());
    });
  }

  /** Two fingers: the motion of their midpoint pans, the change of their distance zooms. */
  #pinch(id: number, at: [number, number]) {
    const [a, b] = [...this.#down.values()];
    const before = pair(a, b);
    this.#down.set(id, at);
    const [c, d] = [...this.#down.values()];
    const now = pair(c, d);
    this.#viewport.with((view) => {
      view.pan(now.x - before.x, now.y - before.y);
      if (before.apart > 0 && now.apart > 0) view.zoom(now.apart / before.apart, now.x, now.y);
    });
  }

  #wheel(event: WheelEvent) {
    event.preventDefault();
    if (this.#gesture?.kind === 'handle') return;
    const factor = wheelFactor(event, this.#element.clientHeight);
    if (event.altKey && this.#region.paints) return this.#region.resize(factor, this.#at(event));
    this.#viewport.with((view) => view.zoom(factor, ...this.#at(event)));
  }

  #hover(event: PointerEvent, at: [number, number]) {
    if (event.pointerType === 'touch') return;
    this.#aim(event, at);
    const isMovable = this.#handle !== undefined && !areHandlesLocked(this.#store.get().document);
    this.#element.dataset.over = isMovable ? 'handle' : '';
    const pointedAt = this.#gizmoPart ? undefined : this.#handle;
    this.#actions.look({ gizmoPart: this.#gizmoPart, pointedAt });
    this.#region.hover(at);
  }

  #handleAt(at: [number, number], radius: number) {
    return this.#viewport.with((view) => view.pickHandle(...at, radius));
  }

  #vertexAt(event: MouseEvent, at: [number, number]) {
    return this.#viewport.with((view) => view.pickVertex(...at, near(event)));
  }

  #become(gesture: Gesture | null) {
    if (gesture?.kind !== 'press') clearTimeout(this.#longPressTimer);
    this.#gesture = gesture;
    this.#element.dataset.gesture = gesture?.kind ?? '';
    if (gesture && gesture.kind !== 'region') this.#region.hide();
  }
}

/** Whether a button acts as the right one: on a Mac also the left one with Ctrl. */
const isRight = ({ button, ctrlKey }: PointerEvent) =>
  button === 2 || (IS_MAC && button === 0 && ctrlKey);

/** Shift: at constant height; Ctrl or Cmd: vertically. */
function planeOf(event: MouseEvent) {
  if (event.ctrlKey || event.metaKey) return 'vertical';
  return event.shiftKey ? 'horizontal' : 'screen';
}
