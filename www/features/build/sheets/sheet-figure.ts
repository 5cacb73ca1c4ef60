/**
 * One sheet as SVG: a path for each layer, and above them one for each mark, regardless of the
 * number of parts. The part under the pointer is found by point-in-path tests on the outlines.
 */

import { element, setAttribute, setText } from '../../../ui/dom.ts';
import { svgElement } from '../../../ui/svg.ts';
import type { SheetPicture } from '../../../solver/types.ts';

/** `failed`: has a panel beyond its limit; `chosen`: selected; `pointed`: under the pointer. */
type Mark = 'failed' | 'chosen' | 'pointed';

/** Paths above the layers, from bottom to top. `failed-sides` are the sides whose beams fail. */
const OVER = ['failed', 'chosen', 'failed-sides', 'pointed'] as const;
const ruler = document.createElement('canvas').getContext('2d');

function path(kind: string, d: string, stroke?: string) {
  return svgElement('path', { class: kind, d, ...(stroke && { stroke }) });
}

export class SheetFigure {
  #svg = svgElement('svg', { role: 'img' });
  #caption = element('figcaption');
  figure = element('figure', this.#svg, this.#caption);
  #over = OVER.map((kind) => path(kind, ''));
  #sheet: SheetPicture | null = null;
  /** The outlines for hit testing, created on first use. */
  #outlines: Path2D[] | null = null;

  /** Assigns a sheet and shows its size and name; `draw` follows. */
  take(sheet: SheetPicture) {
    this.#sheet = sheet;
    this.#outlines = null;
    setAttribute(this.#svg, 'viewBox', `0 0 ${sheet.size.join(' ')}`);
    setAttribute(this.#svg, 'aria-label', sheet.name);
    setText(this.#caption, sheet.name);
  }

  /**
   * Draws the sheet.
   * @param failed panels that exceed their limit
   */
  draw(failed: ReadonlySet<number>) {
    if (!this.#sheet) return;
    const { layers, colour, outlines, failed: sides } = this.#sheet;
    const under = layers.map(({ name, colour, path: d }) => path(name.toLowerCase(), d, colour));
    this.#svg.replaceChildren(...under, path('cut', outlines.join(''), colour), ...this.#over);
    this.#set('failed-sides', sides);
    this.#set('pointed', '');
    this.mark('failed', (own) => own.some((panel) => failed.has(panel)));
  }

  /**
   * Marks these parts only.
   * @returns the marked parts
   */
  mark(mark: Mark, isMarked: (panels: number[], part: number) => boolean): number[] {
    const { outlines, panels } = this.#sheet ?? { outlines: [], panels: [] };
    const marked = [...outlines.keys()].filter((part) => isMarked(panels[part], part));
    this.#set(mark, marked.map((part) => outlines[part]).join(''));
    return marked;
  }

  /** Whether marked parts are visible in a scroller. */
  isInSight(mark: Mark, place: Element) {
    const own = this.#over[OVER.indexOf(mark)].getBoundingClientRect();
    const boxes = [place, place.closest('section')].map((box) => box?.getBoundingClientRect());
    return boxes.every(
      (box) => !box || (own.bottom > box.top && own.top < box.bottom && own.right > box.left),
    );
  }

  /** Scrolls the marked parts into view. */
  reveal(mark: Mark) {
    this.#over[OVER.indexOf(mark)].scrollIntoView({ block: 'nearest', inline: 'nearest' });
  }

  /** The part at the pointer, or -1. */
  partAt({ clientX, clientY }: { clientX: number; clientY: number }) {
    const toWindow = this.#svg.getScreenCTM();
    if (!toWindow || !this.#sheet) return -1;
    const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(toWindow.inverse());
    this.#outlines ??= this.#sheet.outlines.map((outline) => new Path2D(outline));
    return this.#outlines.findIndex((outline) => ruler?.isPointInPath(outline, x, y));
  }

  get name() {
    return this.#sheet?.name ?? '';
  }

  nameOf(part: number) {
    return this.#sheet?.parts[part] ?? '';
  }

  panelsOf(part: number) {
    return this.#sheet?.panels[part] ?? null;
  }

  #set(kind: (typeof OVER)[number], d: string) {
    setAttribute(this.#over[OVER.indexOf(kind)], 'd', d);
  }
}
