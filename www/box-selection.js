/**
 * Selecting with a box: from left to right what is inside (solid line), from right to left also
 * what it touches (dashed line), as in Rhino and AutoCAD.
 */

import { select } from './selection.js';

/** @typedef {[number, number]} Point CSS pixels within the viewport */

export class BoxSelection {
  #store;
  #viewport;
  #rectangle;

  /**
   * @param {import("./state.js").Store} store
   * @param {import("./viewport.js").Viewport} viewport
   * @param {HTMLElement} rectangle is laid over the viewport
   */
  constructor(store, viewport, rectangle) {
    this.#store = store;
    this.#viewport = viewport;
    this.#rectangle = rectangle;
  }

  /**
   * @param {Point} from
   * @param {Point} to
   */
  draw(from, to) {
    const { left, top, right, bottom } = sidesOf(from, to);
    this.#rectangle.classList.toggle('crossing', isCrossing(from, to));
    this.#rectangle.style.left = `${left}px`;
    this.#rectangle.style.top = `${top}px`;
    this.#rectangle.style.width = `${right - left}px`;
    this.#rectangle.style.height = `${bottom - top}px`;
    this.#rectangle.hidden = false;
  }

  hide() {
    this.#rectangle.hidden = true;
  }

  /**
   * @param {Point} from
   * @param {Point} to
   * @param {import("./selection.js").Combine} combine
   */
  select(from, to, combine) {
    const { mode, selection } = this.#store.get();
    const { left, top, right, bottom } = sidesOf(from, to);
    const found = this.#viewport.with((view) =>
      mode === 'vertices'
        ? view.boxVertices(left, top, right, bottom)
        : view.boxFaces(left, top, right, bottom, isCrossing(from, to)),
    );
    this.#store.set({ selection: select(selection, mode, found ?? [], combine) });
  }
}

/**
 * @param {Point} from
 * @param {Point} to
 */
function sidesOf(from, to) {
  return {
    left: Math.min(from[0], to[0]),
    top: Math.min(from[1], to[1]),
    right: Math.max(from[0], to[0]),
    bottom: Math.max(from[1], to[1]),
  };
}

/**
 * @param {Point} from
 * @param {Point} to
 */
function isCrossing(from, to) {
  return to[0] < from[0];
}
