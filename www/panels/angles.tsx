/**
 * Histogram of the angles at the corners of the faces (Fig. 7 of the paper): bars for the current
 * shape, over the outline of the original.
 */

import './angles.css';
import { useRef, useState } from 'preact/hooks';
import { useAnswer } from '../store/use-answer.ts';
import { useApp } from '../store/use-app.ts';
import { Outline } from '../ui/components/histogram.tsx';
import { count, groupDigits } from '../ui/words.ts';

const EVERY_MS = 150;
const HALF_TURN = 180;
const TICKS = [0, 45, 90, 135, 180];

/** The number of corners in each range of angles. */
interface Counts {
  original: number[];
  now: number[];
}

export function Angles() {
  const { store, actions } = useApp();
  const { state } = store;
  const place = useRef<HTMLDivElement>(null);
  const counts = useAnswer(
    place,
    EVERY_MS,
    () => state.numbers,
    () => (store.get().model?.faces ? actions.reportErrors(actions.ask.angles()) : undefined),
  );
  return (
    <div ref={place}>
      {state.model?.faces ? (
        <Histogram {...(counts ?? { original: [], now: [] })} />
      ) : (
        <p class="quiet">The model has no faces, so there are no angles.</p>
      )}
    </div>
  );
}

function Histogram({ original, now }: Counts) {
  const most = Math.max(...original, ...now, 1);
  const bars = useRef<HTMLDivElement>(null);
  /** The bar under the pointer. */
  const [over, setOver] = useState<number | null>(null);
  const isKnown = now.length > 0;
  const all = now.reduce((sum, count) => sum + count, 0);
  const middle = isKnown ? `${middleHalf(original)}, now ${middleHalf(now)}` : '';
  const bound = (k: number) => (k * HALF_TURN) / now.length;

  function point({ clientX }: PointerEvent) {
    const { left, width } = bars.current!.getBoundingClientRect();
    const bin = Math.floor(((clientX - left) / width) * now.length);
    if (isKnown) setOver(Math.min(Math.max(bin, 0), now.length - 1));
  }

  return (
    <div class="angles">
      <p class="angle-key">
        <span class="now" />
        now
        <span class="original" />
        original
        <span class="most figure">{isKnown && count(most, 'corner')}</span>
      </p>
      <div
        ref={bars}
        class="bars"
        role="img"
        aria-label={
          isKnown
            ? `${count(all, 'corner')} by angle. The middle half: originally ${middle}`
            : undefined
        }
        onPointerMove={point}
        onPointerLeave={() => setOver(null)}
      >
        {now.map((count, k) => (
          <i key={k} style={{ height: count > 0 ? `max(1px, ${(100 * count) / most}%)` : '0' }} />
        ))}
        <Outline counts={original} most={most} />
      </div>
      <div class="ticks quiet" aria-hidden="true">
        {TICKS.map((tick) => (
          <span key={tick}>{tick}°</span>
        ))}
      </div>
      <p class="quiet">
        {isKnown &&
          (over === null
            ? `The middle half: ${middle}`
            : `${bound(over)}° to ${bound(over + 1)}°: ${groupDigits(original[over])}, now ${groupDigits(now[over])}`)}
      </p>
    </div>
  );
}

/** The range of angles of the middle half of the corners. */
function middleHalf(counts: number[]) {
  const all = counts.reduce((sum, count) => sum + count, 0);
  if (all === 0) return 'none';
  const binOf = (part: number) => {
    let sum = 0;
    return counts.findIndex((count) => (sum += count) >= part * all && count > 0);
  };
  const [from, to] = [binOf(0.25), binOf(0.75) + 1].map((bin) => (bin * HALF_TURN) / counts.length);
  return `${from}° to ${to}°`;
}
