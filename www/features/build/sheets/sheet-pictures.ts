/** The sheets as they will be cut; pointing at a part or a panel of the model marks both. */

import { element, setText } from '../../../ui/dom.ts';
import { SheetFigure } from './sheet-figure.ts';
import type { SheetPicture } from '../../../solver/types.ts';

const HINT = 'Point at a part, or at a panel of the model';
/** Maximum number of parts listed by name. */
const MOST_NAMES = 6;

export function sheetPictures({
  point,
  choose,
}: {
  point: (panels: number[] | null) => void;
  choose: (panels: number[]) => void;
}) {
  const words = element('p.quiet', HINT);
  const place = element('div.sheets', { tabindex: '0', role: 'group', 'aria-label': 'Sheets' });
  let shown: SheetFigure[] = [];
  /** The sheets still to be drawn, one per frame. */
  let undrawn: SheetFigure[] = [];
  let failed: ReadonlySet<number> = new Set();
  /** The part under the pointer here. */
  let pointed: { sheet: SheetFigure; part: number } | null = null;
  /** The panel under the pointer in the view. */
  let inView: number | undefined;
  const isInView = (own: number[]) => inView !== undefined && own.includes(inView);

  function under(event: MouseEvent) {
    const { target } = event;
    const figure = target instanceof Element ? target.closest('figure') : null;
    const sheet = shown.find((own) => own.figure === figure);
    const part = sheet?.partAt(event) ?? -1;
    return sheet && part >= 0 ? { sheet, part, panels: sheet.panelsOf(part) } : null;
  }

  function pointAt(now: ReturnType<typeof under>) {
    if (now?.sheet === pointed?.sheet && now?.part === pointed?.part) return;
    pointed = now;
    for (const sheet of shown)
      sheet.mark('pointed', (_, part) => sheet === now?.sheet && part === now.part);
    setText(words, now ? whereIs(now.sheet, [now.part]) : HINT);
    point(now?.panels ?? null);
  }

  place.addEventListener('pointermove', (event) => pointAt(under(event)));
  place.addEventListener('pointerleave', () => pointAt(null));
  place.addEventListener('click', (event) => {
    const panels = under(event)?.panels;
    if (panels) choose(panels);
  });

  function whereIs(sheet: SheetFigure, parts: number[]) {
    const names = parts.slice(0, MOST_NAMES).map((part) => sheet.nameOf(part));
    const more = parts.length > MOST_NAMES ? ` and ${parts.length - MOST_NAMES} more` : '';
    return `${names.join(', ')}${more} on ${sheet.name}`;
  }

  function whereAre(found: { sheet: SheetFigure; parts: number[] }[]) {
    if (found.length === 0) return 'This panel is on none of the sheets shown.';
    const isFar = !found.some(({ sheet }) => sheet.isInSight('pointed', place));
    const all = found.map(({ sheet, parts }) => whereIs(sheet, parts)).join(', ');
    return isFar ? `${all}: click the panel to see it` : all;
  }

  /** Draws one sheet per frame: many at once would block the page. */
  function drawNext() {
    const sheet = undrawn.shift();
    sheet?.draw(failed);
    sheet?.mark('pointed', isInView);
    if (undrawn.length > 0) requestAnimationFrame(drawNext);
  }

  return {
    place,
    /**
     * @param failing panels that exceed their limit
     * @param more number of sheets that are not shown
     */
    show(sheets: SheetPicture[], failing: ReadonlySet<number>, more: number) {
      failed = failing;
      pointed = null;
      // The old drawings stay until replaced, so that nothing flickers while the shape moves.
      shown = sheets.map((sheet, k) => {
        const figure = shown[k] ?? new SheetFigure();
        figure.take(sheet);
        return figure;
      });
      const rest = more > 0 ? [element('p.quiet', `and ${more} more`)] : [];
      const hint = sheets.length > 0 ? [words] : [];
      place.replaceChildren(...hint, ...shown.map(({ figure }) => figure), ...rest);
      const isDrawing = undrawn.length > 0;
      undrawn = [...shown];
      if (!isDrawing) drawNext();
    },
    /** Marks the parts whose panels are all in this set. */
    mark(panels: ReadonlySet<number>) {
      const isChosen = (own: number[]) => own.length > 0 && own.every((panel) => panels.has(panel));
      const counts = shown.map((sheet) => sheet.mark('chosen', isChosen).length);
      const count = counts.reduce((sum, own) => sum + own, 0);
      if (count === 1) shown[counts.indexOf(1)].reveal('chosen');
    },
    /**
     * Marks the parts that contain a panel of the model, and names their sheets.
     * @param panel under the pointer in the view
     */
    pointAtPanel(panel: number | undefined) {
      pointed = null;
      inView = panel;
      const found = shown
        .map((sheet) => ({ sheet, parts: sheet.mark('pointed', isInView) }))
        .filter(({ parts }) => parts.length > 0);
      setText(words, panel === undefined ? HINT : whereAre(found));
      if (panel === undefined) return point(null);
      const [{ sheet, parts }] = found.length > 0 ? found : [{ sheet: null, parts: [] }];
      const isOne = found.length === 1 && parts.length === 1;
      point((isOne && sheet?.panelsOf(parts[0])) || [panel]);
    },
    /** Scrolls to the panel that is pointed at in the view. */
    revealPointed() {
      shown.find((sheet) => sheet.mark('pointed', isInView).length > 0)?.reveal('pointed');
    },
  };
}
