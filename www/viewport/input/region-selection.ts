/**
 * Selection by a region of the screen.
 *
 * | shape | from left to right | from right to left |
 * |---|---|---|
 * | box | elements inside (solid line) | also elements that it crosses (dashed line), as in Rhino |
 * | lasso | elements inside | elements inside |
 * | paint | elements that the brush touches | the same |
 *
 * Touching, box and lasso take what they cross in either direction: a finger has no habit of one.
 */

import { NOTHING, resizedBrush, select, type Combine } from '../../store/selection.ts';
import { svgElement } from '../../ui/dom.ts';
import type { Store } from '../../store/state.ts';
import type { Viewport } from '../viewport.ts';
import type { Actions } from '../../store/actions.ts';

/** CSS pixels within the viewport */
type Point = [number, number];

/** Number of corners of the brush outline. */
const BRUSH_CORNERS = 20;
/** Minimal distance of lasso corners, in CSS pixels. */
const LASSO_STEP = 3;

export class RegionSelection {
  #store;
  #viewport;
  #actions;
  #overlay = svgElement('svg');
  #outline = svgElement('polygon');
  #brush = svgElement('circle');
  /** Pointer positions since the press. */
  #path: Point[] = [];
  #combine: Combine = 'replace';
  /** Selection that Escape restores. */
  #before = NOTHING;

  constructor(store: Store, viewport: Viewport, actions: Actions) {
    this.#store = store;
    this.#viewport = viewport;
    this.#actions = actions;
    this.#overlay.id = 'region';
    this.#overlay.setAttribute('aria-hidden', 'true');
    this.#overlay.append(this.#outline, this.#brush);
    viewport.element.after(this.#overlay);
    viewport.element.addEventListener('pointerleave', () => this.hide());
    store.subscribe(['tool', 'shape'], () => this.hide());
  }

  /** Whether the press itself already selects. */
  get paints() {
    const { tool, shape } = this.#store.get();
    return tool === 'select' && shape === 'paint';
  }

  begin(at: Point, combine: Combine) {
    this.#path = [at];
    this.#combine = combine;
    this.#before = this.#store.get().selection;
    if (!this.paints) return;
    if (combine === 'replace') {
      this.#actions.selectNothing();
      this.#combine = 'add';
    }
    this.move(at);
  }

  move(at: Point) {
    const { shape } = this.#store.get();
    const last = this.#path[this.#path.length - 1];
    if (shape === 'paint') {
      this.hover(at);
      this.#take(stroke(last, at, this.#store.get().brush), true);
      this.#path = [at];
    } else if (shape === 'lasso') {
      if (Math.hypot(at[0] - last[0], at[1] - last[1]) >= LASSO_STEP) this.#path.push(at);
      this.#draw([...this.#path, at], this.#store.get().touching);
    } else {
      this.#path = [this.#path[0], at];
      this.#draw(corners(this.#path[0], at), this.#crosses(at));
    }
  }

  end(at: Point, combine: Combine) {
    this.move(at);
    const { shape } = this.#store.get();
    if (shape !== 'paint') {
      this.#combine = combine;
      const { touching } = this.#store.get();
      if (shape === 'lasso') this.#take([...this.#path, at], touching);
      else this.#take(corners(this.#path[0], at), this.#crosses(at));
    }
    this.hide();
  }

  /** Restores the previous selection. */
  cancel() {
    this.#actions.look({ selection: this.#before });
    this.hide();
  }

  /** Shows the size of the brush. */
  hover([x, y]: Point) {
    if (!this.paints) return;
    this.#overlay.classList.add('painting');
    this.#brush.setAttribute('cx', String(x));
    this.#brush.setAttribute('cy', String(y));
    this.#brush.setAttribute('r', String(this.#store.get().brush));
  }

  /** Changes the radius of the brush by a factor. */
  resize(factor: number, at: Point) {
    this.#actions.look({ brush: resizedBrush(this.#store.get().brush, factor) });
    this.hover(at);
  }

  hide() {
    this.#overlay.classList.remove('drawing', 'painting');
  }

  /** Whether a box from the press to here takes what it crosses. */
  #crosses(to: Point) {
    return this.#store.get().touching || to[0] < this.#path[0][0];
  }

  #draw(points: Point[], crossing: boolean) {
    this.#overlay.classList.add('drawing');
    this.#outline.classList.toggle('crossing', crossing);
    this.#outline.setAttribute('points', points.map((point) => point.join(',')).join(' '));
  }

  /**
   * Selects the elements in a polygon, combined as the gesture requires.
   * @param touching also elements partly inside
   */
  #take(points: Point[], touching: boolean) {
    const { mode, selection, through } = this.#store.get();
    const outline = Float32Array.from(points.flat());
    const found = this.#viewport.with((view) => {
      if (mode === 'vertices') return view.verticesIn(outline, through);
      if (mode === 'edges') return view.edgesIn(outline, touching, through);
      return view.facesIn(outline, touching, through);
    });
    if (!found || (found.length === 0 && this.#combine !== 'replace')) return;
    this.#actions.look({ selection: select(selection, mode, found, this.#combine) });
  }
}

function corners(from: Point, to: Point): Point[] {
  return [from, [to[0], from[1]], to, [from[0], to[1]]];
}

/** Returns the area swept by a round brush: two half circles and the strip between them. */
function stroke(from: Point, to: Point, radius: number): Point[] {
  const along = Math.atan2(to[1] - from[1], to[0] - from[0]);
  return Array.from({ length: BRUSH_CORNERS }, (_, i) => {
    // The first half of the circle is ahead of `to`, the second behind `from`.
    const [x, y] = 2 * i < BRUSH_CORNERS ? to : from;
    const angle = along - Math.PI / 2 + ((i + 0.5) * 2 * Math.PI) / BRUSH_CORNERS;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
}
