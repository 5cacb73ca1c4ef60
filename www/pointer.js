/**
 * Mouse, pen and touch on the viewport.
 *
 * | | Drag tool | Select tool |
 * |---|---|---|
 * | left on a handle | moves it | moves it |
 * | left elsewhere, drag | orbits | box, lasso or brush: see `region-selection.js` |
 * | Alt + left on a vertex | makes it a handle and moves it | same |
 * | left click | selects; Shift adds, Ctrl or Cmd removes | same |
 * | double-click | vertex: handle; edge: loop; face: flat patch; nothing: fit all | same |
 * | right, middle or Shift+right | orbits, pans | same |
 * | wheel, pinch | zooms to the cursor | same |
 * | touch | one finger as left, two pan and zoom | same |
 */

import { isFirstPictureThere } from './first-picture.js';
import { HandleDrag } from './handle-drag.js';
import { NOTHING, combineOf, select } from './selection.js';

/** Nearer than this, in CSS pixels, a pointer is on a dot. */
const NEAR = { mouse: 12, pen: 14, touch: 24 };
/** A press that moves less is a click. */
const CLICK_SLOP = 4;
/** Wheel delta, in pixels, that zooms by e; and of a pinch, which comes as a wheel with Ctrl. */
const WHEEL_PIXELS = 700;
const PINCH_PIXELS = 100;
const LINE_PIXELS = 16;

/**
 * What a press has become: nothing yet, or one of these until it is released.
 * @typedef {{ kind: "press" | "orbit" | "pan" | "region" | "pinch" | "making" | "spent" } | { kind: "handle", drag: HandleDrag }} Gesture
 */

export class PointerInput {
  #store;
  #solver;
  #viewport;
  #element;
  #region;
  #commands;
  /** Where each pointer that is down was last. @type {Map<number, [number, number]>} */
  #down = new Map();
  /** @type {[number, number]} */
  #start = [0, 0];
  /** The handle that was pressed. @type {number | undefined} */
  #handle;
  /** @type {Gesture | null} */
  #gesture = null;

  /**
   * @param {import("./state.js").Store} store
   * @param {import("./solver-client.js").SolverClient} solver
   * @param {import("./viewport.js").Viewport} viewport
   * @param {import("./region-selection.js").RegionSelection} region
   * @param {{ addHandles: (vertices: number[]) => Promise<void>, fitAll: () => void,
   *   doubleClick: (mode: import("./state.js").Mode, item: number, event: MouseEvent) => void }} commands
   */
  constructor(store, solver, viewport, region, commands) {
    this.#store = store;
    this.#solver = solver;
    this.#viewport = viewport;
    this.#element = viewport.element;
    this.#region = region;
    this.#commands = commands;
    const listen = /** @type {HTMLElement["addEventListener"]} */ (
      this.#element.addEventListener.bind(this.#element)
    );
    listen('pointerdown', (event) => this.#press(event));
    listen('pointermove', (event) => this.#move(event));
    listen('pointerup', (event) => this.#release(event));
    listen('pointercancel', () => this.cancel());
    listen('dblclick', (event) => this.#doubleClick(event));
    listen('wheel', (event) => this.#wheel(event), { passive: false });
    listen('contextmenu', (event) => event.preventDefault());
    window.addEventListener('keydown', (event) => this.#lockAxis(event), { capture: true });
    store.subscribe(['tool'], ({ tool }) => (this.#element.dataset.tool = tool));
    store.subscribe(['tape'], ({ tape }) =>
      this.#element.toggleAttribute('data-measures', tape !== null),
    );
  }

  /** Ends the gesture and takes back what it did. Whether there was one. */
  cancel() {
    const gesture = this.#gesture;
    if (!gesture) return false;
    if (gesture.kind === 'handle') gesture.drag.cancel();
    if (gesture.kind === 'region') this.#region.cancel();
    this.#become(this.#down.size > 0 ? { kind: 'spent' } : null);
    return true;
  }

  /**
   * @param {MouseEvent} event
   * @returns {[number, number]}
   */
  #at(event) {
    const box = this.#element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  /** @param {PointerEvent} event */
  #press(event) {
    if (!this.#viewport.view || isFirstPictureThere()) return;
    const at = this.#at(event);
    this.#element.focus({ preventScroll: true });
    this.#element.setPointerCapture(event.pointerId);
    this.#down.set(event.pointerId, at);
    if (this.#down.size > 1) return this.#secondFinger();
    this.#start = at;
    this.#handle = undefined;
    if (event.button === 1) {
      event.preventDefault();
      this.#become({ kind: 'pan' });
    } else if (event.button === 2) {
      this.#become({ kind: event.shiftKey ? 'pan' : 'orbit' });
    } else if (event.button === 0) {
      this.#handle = this.#handleAt(event, at);
      if (event.altKey && this.#handle === undefined) return void this.#makeHandle(event, at);
      const paints = this.#handle === undefined && this.#region.paints;
      this.#become({ kind: paints ? 'region' : 'press' });
      if (paints) this.#region.begin(at, combineOf(event));
    }
  }

  /**
   * Makes the vertex under the pointer a handle, and drags it when it is one.
   * @param {PointerEvent} event
   * @param {[number, number]} at
   */
  async #makeHandle(event, at) {
    const vertex = this.#vertexAt(event, at);
    /** @type {Gesture} */
    const making = { kind: vertex === undefined ? 'press' : 'making' };
    this.#become(making);
    if (vertex === undefined) return;
    await this.#commands.addHandles([vertex]);
    // Released or taken back meanwhile.
    if (this.#gesture !== making) return;
    this.#handle = vertex;
    this.#begin();
    const last = this.#down.get(event.pointerId);
    const gesture = /** @type {Gesture | null} */ (this.#gesture);
    if (gesture?.kind === 'handle' && last) gesture.drag.move(...last);
  }

  /** X, Y and Z keep a dragged handle on a line along that axis, and let it go again. @param {KeyboardEvent} event */
  #lockAxis(event) {
    const axis = ['x', 'y', 'z'].indexOf(event.key.toLowerCase());
    if (axis < 0 || this.#gesture?.kind !== 'handle') return;
    event.preventDefault();
    event.stopPropagation();
    this.#gesture.drag.toggleAxis(axis);
  }

  /** A second finger turns what the first one began into pan and zoom; a dragged handle goes on. */
  #secondFinger() {
    if (this.#gesture?.kind !== 'handle') this.#become({ kind: 'pinch' });
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const at = this.#at(event);
    const last = this.#down.get(event.pointerId);
    if (!last) return this.#hover(event, at);
    if (this.#gesture?.kind === 'pinch') return this.#pinch(event.pointerId, at);
    this.#down.set(event.pointerId, at);
    if (this.#gesture?.kind === 'press') {
      const moved = Math.hypot(at[0] - this.#start[0], at[1] - this.#start[1]);
      if (moved < CLICK_SLOP) return;
      this.#begin();
    }
    const [dx, dy] = [at[0] - last[0], at[1] - last[1]];
    switch (this.#gesture?.kind) {
      case 'handle':
        this.#gesture.drag.hold(planeOf(event));
        return this.#gesture.drag.move(...at);
      case 'orbit':
        return void this.#viewport.with((view) => view.orbit(dx, dy));
      case 'pan':
        return void this.#viewport.with((view) => view.pan(dx, dy));
      case 'region':
        return this.#region.move(at);
    }
  }

  /** The press has become a drag: of a handle, of the camera, or of a region. */
  #begin() {
    const { view } = this.#viewport;
    if (this.#handle !== undefined && view) {
      const drag = new HandleDrag(this.#store, this.#solver, view, this.#handle, ...this.#start);
      this.#become({ kind: 'handle', drag });
    } else {
      const selects = this.#store.get().tool === 'select';
      this.#become({ kind: selects ? 'region' : 'orbit' });
      if (selects) this.#region.begin(this.#start, 'replace');
    }
  }

  /** @param {PointerEvent} event */
  #release(event) {
    const at = this.#at(event);
    if (!this.#down.delete(event.pointerId)) return;
    const gesture = this.#gesture;
    switch (gesture?.kind) {
      case 'handle':
        gesture.drag.move(...at);
        gesture.drag.end();
        break;
      case 'press':
        this.#click(event, at);
        break;
      case 'region':
        this.#region.end(at, combineOf(event));
        break;
    }
    this.#become(this.#down.size > 0 ? { kind: 'spent' } : null);
  }

  /**
   * @param {PointerEvent} event
   * @param {[number, number]} at
   */
  #click(event, at) {
    const { mode, selection, tape } = this.#store.get();
    if (tape) {
      const end = this.#handle ?? this.#vertexAt(event, at);
      const isOther = tape.length === 1 && tape[0] !== end;
      if (end !== undefined) this.#store.set({ tape: isOther ? [...tape, end] : [end] });
      return;
    }
    const combine = combineOf(event);
    const item = this.#handle ?? this.#pick(mode, event, at);
    if (item !== undefined) {
      const what = this.#handle === undefined ? mode : 'vertices';
      this.#store.set({ selection: select(selection, what, [item], combine) });
    } else if (combine === 'replace') {
      this.#store.set({ selection: NOTHING });
    }
  }

  /**
   * What is under the pointer.
   * @param {import("./state.js").Mode} mode
   * @param {MouseEvent} event
   * @param {[number, number]} at
   */
  #pick(mode, event, at) {
    if (mode === 'vertices') return this.#vertexAt(event, at);
    return this.#viewport.with((view) =>
      mode === 'edges' ? view.pickEdge(...at, near(event)) : view.pickFace(...at),
    );
  }

  /** @param {MouseEvent} event */
  #doubleClick(event) {
    const at = this.#at(event);
    const { mode, tape } = this.#store.get();
    if (tape) return;
    const item = this.#pick(mode, event, at);
    if (item === undefined) {
      const face = this.#viewport.with((view) => view.pickFace(...at));
      if (face === undefined) this.#commands.fitAll();
    } else if (mode === 'vertices') this.#commands.addHandles([item]);
    else this.#commands.doubleClick(mode, item, event);
  }

  /**
   * Two fingers: their middle pans, their distance zooms.
   * @param {number} id
   * @param {[number, number]} at
   */
  #pinch(id, at) {
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

  /** @param {WheelEvent} event */
  #wheel(event) {
    event.preventDefault();
    if (this.#gesture?.kind === 'handle') return;
    const unit = [1, LINE_PIXELS, this.#element.clientHeight][event.deltaMode] ?? 1;
    const exponent = (-event.deltaY * unit) / (event.ctrlKey ? PINCH_PIXELS : WHEEL_PIXELS);
    const factor = Math.exp(Math.max(-0.5, Math.min(0.5, exponent)));
    this.#viewport.with((view) => view.zoom(factor, ...this.#at(event)));
  }

  /**
   * @param {PointerEvent} event
   * @param {[number, number]} at
   */
  #hover(event, at) {
    if (event.pointerType === 'touch') return;
    const over = this.#handleAt(event, at) !== undefined;
    this.#element.dataset.over = over ? 'handle' : '';
    this.#region.hover(at);
  }

  /**
   * @param {PointerEvent} event
   * @param {[number, number]} at
   */
  #handleAt(event, at) {
    return this.#viewport.with((view) => view.pickHandle(...at, near(event)));
  }

  /**
   * @param {MouseEvent} event
   * @param {[number, number]} at
   */
  #vertexAt(event, at) {
    return this.#viewport.with((view) => view.pickVertex(...at, near(event)));
  }

  /** @param {Gesture | null} gesture */
  #become(gesture) {
    this.#gesture = gesture;
    this.#element.dataset.gesture = gesture?.kind ?? '';
    if (gesture && gesture.kind !== 'region') this.#region.hide();
  }
}

/**
 * Shift keeps a dragged handle at its height, Ctrl or Cmd above its place.
 * @param {MouseEvent} event
 */
function planeOf(event) {
  if (event.ctrlKey || event.metaKey) return 'vertical';
  return event.shiftKey ? 'horizontal' : 'screen';
}

/** @param {MouseEvent} event */
function near(event) {
  const type = event instanceof PointerEvent ? event.pointerType : 'mouse';
  return NEAR[/** @type {keyof typeof NEAR} */ (type)] ?? NEAR.mouse;
}

/**
 * @param {[number, number]} a
 * @param {[number, number]} b
 */
function pair(a, b) {
  return {
    x: (a[0] + b[0]) / 2,
    y: (a[1] + b[1]) / 2,
    apart: Math.hypot(a[0] - b[0], a[1] - b[1]),
  };
}
