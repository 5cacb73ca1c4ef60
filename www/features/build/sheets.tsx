/** The sheets as they will be cut; pointing at a part or a panel of the model marks both. */

import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { useApp } from '../../store/use-app.ts';
import { MOST_SHEETS } from './live-build.ts';
import { Sheet, type Drawn } from './sheet.tsx';
import type { Built } from '../../solver/types.ts';
import type { Parts } from './parts.ts';

const HINT = 'Point at a part, or at a panel of the model';
/** Maximum number of parts listed by name. */
const MOST_NAMES = 6;
/** Colour of the panels of the part pointed at. */
const POINTED: [number, number, number] = [230, 120, 20];
/** A press that moves farther than this, in CSS pixels, is a drag of the view. */
const STILL = 4;

/** A part of a sheet, or a panel in the view. */
type Pointed = { sheet: number; part: number } | { panel: number };

export function Sheets({ parts }: { parts: Parts }) {
  const { store, actions } = useApp();
  const { faces } = store.state.selection;
  const built = parts.built.value;
  const shown = useOnePerFrame(built);
  const [pointed, setPointed] = useState<Pointed | null>(null);
  const place = useRef<HTMLDivElement>(null);
  /** The marks of the parts that are pointed at, of each sheet. */
  const marks = useRef<(SVGPathElement | null)[]>([]);

  const chosen = shown.map((drawn) => partsOf(drawn, (panels) => isWithin(panels, faces)));
  const count = chosen.reduce((sum, parts) => sum + parts.length, 0);
  const found = shown.map((drawn, k) => partsAt(pointed, drawn, k));
  const isFar = useFar(place, marks, pointed);
  const more = (built?.report.sheets ?? 0) - MOST_SHEETS;

  /** Marks a part or a panel, and tints the panels of its only part in the view. */
  function point(to: Pointed | null) {
    if (isSame(to, pointed)) return;
    setPointed(to);
    const parts = shown.flatMap((drawn, k) =>
      partsAt(to, drawn, k).map((part) => drawn.sheet.panels[part]),
    );
    const panels = parts.length === 1 ? parts[0] : to && 'panel' in to ? [to.panel] : null;
    const vertices = new Uint32Array(0);
    actions.tint(
      'pointed',
      panels && { faces: Uint32Array.from(panels), vertices, colour: POINTED },
    );
  }
  // What is pointed at on a sheet is another part when the parts are made again.
  useEffect(() => {
    if (pointed && 'part' in pointed) point(null);
  }, [built]);
  usePanelUnderPointer({
    point: (panel) => point(panel === undefined ? null : { panel }),
    press: () =>
      marks.current[found.findIndex((parts) => parts.length > 0)]?.scrollIntoView({
        block: 'nearest',
        inline: 'nearest',
      }),
  });

  return (
    <div class="sheets" ref={place} tabindex={0} role="group" aria-label="Sheets">
      {shown.length > 0 && <p class="quiet">{wordsFor(pointed, shown, found, isFar)}</p>}
      {shown.map((drawn, k) => (
        <Sheet
          key={k}
          drawn={drawn}
          chosen={chosen[k]}
          isOnly={count === 1 && chosen[k].length === 1}
          pointed={found[k]}
          mark={(path) => {
            marks.current[k] = path;
          }}
          point={(part) => point(part === null ? null : { sheet: k, part })}
          choose={(part) => actions.select({ vertices: [], faces: drawn.sheet.panels[part] })}
        />
      ))}
      {more > 0 && <p class="quiet">and {more} more</p>}
    </div>
  );
}

function isSame(a: Pointed | null, b: Pointed | null) {
  if (!a || !b) return a === b;
  if ('panel' in a) return 'panel' in b && a.panel === b.panel;
  return 'part' in b && a.part === b.part && a.sheet === b.sheet;
}

/** The parts of a sheet with such panels. */
const partsOf = ({ sheet }: Drawn, isMeant: (panels: number[]) => boolean) =>
  [...sheet.panels.keys()].filter((part) => isMeant(sheet.panels[part]));

const isWithin = (panels: number[], faces: ReadonlySet<number>) =>
  panels.length > 0 && panels.every((panel) => faces.has(panel));

/** The parts of a sheet that are pointed at. */
function partsAt(pointed: Pointed | null, drawn: Drawn, sheet: number) {
  if (!pointed) return [];
  if ('panel' in pointed) return partsOf(drawn, (panels) => panels.includes(pointed.panel));
  return pointed.sheet === sheet && pointed.part in drawn.sheet.parts ? [pointed.part] : [];
}

/** @param found the parts that are pointed at, of each sheet */
function wordsFor(pointed: Pointed | null, shown: Drawn[], found: number[][], isFar: boolean) {
  if (!pointed) return HINT;
  const places = shown.flatMap(({ sheet }, k) => {
    if (found[k].length === 0) return [];
    const names = found[k].slice(0, MOST_NAMES).map((part) => sheet.parts[part]);
    const others = found[k].length - names.length;
    return `${names.join(', ')}${others > 0 ? ` and ${others} more` : ''} on ${sheet.name}`;
  });
  if (places.length === 0) return 'This panel is on none of the sheets shown.';
  return places.join(', ') + (isFar ? ': click the panel to see it' : '');
}

/**
 * The sheets of a build, which are drawn one per frame: many at once would block the page. The old
 * ones stay until they are replaced, so that nothing flickers while the shape moves.
 */
function useOnePerFrame(built: Built | null) {
  const [shown, setShown] = useState<Drawn[]>([]);
  useEffect(() => {
    const sheets = built?.sheets ?? [];
    const failed = new Set(built?.layer.panels);
    let frame = 0;
    function draw(k: number) {
      setShown((before) => {
        const now = before.slice(0, sheets.length);
        if (k < sheets.length) now[k] = { sheet: sheets[k], failed };
        return now;
      });
      if (k + 1 < sheets.length) frame = requestAnimationFrame(() => draw(k + 1));
    }
    draw(0);
    return () => cancelAnimationFrame(frame);
  }, [built]);
  return shown;
}

/** Whether what a panel in the view marks on the sheets is out of sight. */
function useFar(
  place: { current: HTMLElement | null },
  marks: { current: (SVGPathElement | null)[] },
  pointed: Pointed | null,
) {
  const [isFar, setFar] = useState(false);
  useLayoutEffect(() => {
    const around = [place.current, place.current?.closest('section')];
    const boxes = around.map((box) => box?.getBoundingClientRect());
    const isInSight = (mark: SVGPathElement | null) => {
      const own = mark?.getAttribute('d') ? mark.getBoundingClientRect() : null;
      return boxes.every(
        (box) => own && box && own.bottom > box.top && own.top < box.bottom && own.right > box.left,
      );
    };
    setFar(pointed !== null && 'panel' in pointed && !marks.current.some(isInSight));
  }, [pointed]);
  return isFar;
}

/** Follows the panel under the pointer in the view, except during a drag. */
function usePanelUnderPointer(on: {
  /** called when the panel changes */
  point: (panel: number | undefined) => void;
  /** called when the panel is clicked */
  press: () => void;
}) {
  const { viewport } = useApp();
  const latest = useRef(on);
  latest.current = on;
  useEffect(() => {
    const { element } = viewport;
    const listening = new AbortController();
    const listen = <Type extends 'click' | 'pointermove' | 'pointerleave' | 'pointerdown'>(
      type: Type,
      listener: (event: HTMLElementEventMap[Type]) => void,
    ) => element.addEventListener(type, listener, { signal: listening.signal });
    let pointed: number | undefined;
    let [startX, startY] = [0, 0];

    function become(panel: number | undefined) {
      if (panel === pointed) return;
      pointed = panel;
      latest.current.point(panel);
    }

    listen('pointermove', ({ clientX, clientY, buttons, pointerType }) => {
      if (buttons !== 0 || pointerType === 'touch') return;
      const { left, top } = element.getBoundingClientRect();
      become(viewport.with((view) => view.pickFace(clientX - left, clientY - top)));
    });
    listen('pointerleave', () => become(undefined));
    listen('pointerdown', ({ clientX, clientY }) => {
      [startX, startY] = [clientX, clientY];
    });
    listen('click', ({ clientX, clientY }) => {
      const isStill = Math.hypot(clientX - startX, clientY - startY) < STILL;
      if (pointed !== undefined && isStill) latest.current.press();
    });
    return () => listening.abort();
  }, [viewport]);
}
