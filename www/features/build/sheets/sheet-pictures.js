/** The sheets as they will be cut. A part that is pointed at lights up on the model, and the other way round. */

import { element } from '../../../ui/dom.js';
import { SheetFigure } from './sheet-figure.js';

/** @typedef {import("../../../solver/messages.js").SheetPicture} SheetPicture */

/**
 * @param {{ point: (panels: number[] | null) => void, choose: (panels: number[]) => void }} on
 */
export function sheetPictures({ point, choose }) {
  const place = element('div.sheets', { tabindex: '0', role: 'group', 'aria-label': 'Sheets' });
  /** @type {SheetFigure[]} */
  let shown = [];
  /** What of them is yet to be drawn, one in a frame. @type {SheetFigure[]} */
  let undrawn = [];
  /** @type {ReadonlySet<number>} */
  let failed = new Set();
  /** What is pointed at. @type {{ sheet: SheetFigure, part: number } | null} */
  let pointed = null;

  /** @param {MouseEvent} event */
  function under(event) {
    const { target } = event;
    const figure = target instanceof Element ? target.closest('figure') : null;
    const sheet = shown.find((own) => own.figure === figure);
    const part = sheet?.partAt(event) ?? -1;
    return sheet && part >= 0 ? { sheet, part, panels: sheet.panelsOf(part) } : null;
  }

  /** @param {ReturnType<typeof under>} now */
  function pointAt(now) {
    if (now?.sheet === pointed?.sheet && now?.part === pointed?.part) return;
    pointed?.sheet.mark('pointed', () => false);
    pointed = now;
    now?.sheet.mark('pointed', (_, part) => part === now.part);
    point(now?.panels ?? null);
  }

  place.addEventListener('pointermove', (event) => pointAt(under(event)));
  place.addEventListener('pointerleave', () => pointAt(null));
  place.addEventListener('click', (event) => {
    const panels = under(event)?.panels;
    if (panels) choose(panels);
  });

  /** Many sheets at once would stop the page. */
  function drawNext() {
    undrawn.shift()?.draw(failed);
    if (undrawn.length > 0) requestAnimationFrame(drawNext);
  }

  return {
    place,
    /**
     * @param {SheetPicture[]} sheets
     * @param {ReadonlySet<number>} failing panels that are not within their limit
     * @param {number} more that are not shown
     */
    show(sheets, failing, more) {
      failed = failing;
      pointed = null;
      // Those of before stay until they are drawn: nothing flickers while a shape moves.
      shown = sheets.map((sheet, k) => {
        const figure = shown[k] ?? new SheetFigure();
        figure.take(sheet);
        return figure;
      });
      const rest = more > 0 ? [element('p.quiet', `and ${more} more`)] : [];
      place.replaceChildren(...shown.map(({ figure }) => figure), ...rest);
      const isDrawing = undrawn.length > 0;
      undrawn = [...shown];
      if (!isDrawing) drawNext();
    },
    /** Marks the parts of which all panels are among these. @param {ReadonlySet<number>} panels */
    mark(panels) {
      const isChosen = (/** @type {number[]} */ own) =>
        own.length > 0 && own.every((panel) => panels.has(panel));
      const counts = shown.map((sheet) => sheet.mark('chosen', isChosen));
      const count = counts.reduce((sum, own) => sum + own, 0);
      if (count === 1) shown[counts.indexOf(1)].reveal('chosen');
    },
  };
}
