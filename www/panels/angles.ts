/**
 * Histogram of the angles at the corners of the faces (Fig. 7 of the paper): bars for the current
 * shape, over the outline of the original.
 */

import { button } from '../ui/controls/fields.ts';
import { element, setText, throttled } from '../ui/dom.ts';
import { newestOnly } from '../store/newest-only.ts';
import { groupDigits } from '../ui/format.ts';
import { drawOutline, outline } from '../ui/plot/histogram-svg.ts';
import './angles.css';
import type { AppContext } from '../app/context.ts';

const EVERY_MS = 150;
const HALF_TURN = 180;
const TICKS = [0, 45, 90, 135, 180];

export function anglesPanel(panel: HTMLElement, { store, solver, files, actions }: AppContext) {
  const before = outline();
  const bars = element('div.bars', { role: 'img' });
  const readout = element('p.quiet');
  const key = element(
    'p.angle-key',
    element('span.now'),
    'now',
    element('span.original'),
    'original',
    element('span.most.figure'),
  );
  const saveCsv = async () =>
    files.save('-angles.csv', await actions.ask.table('angles'), 'text/csv');
  const save = button('Save angles as CSV', () => actions.reportErrors(saveCsv()), {
    class: 'bordered small',
  });
  const plot = element(
    'div.angles',
    key,
    bars,
    element(
      'div.ticks.quiet',
      { 'aria-hidden': 'true' },
      ...TICKS.map((tick) => element('span', `${tick}°`)),
    ),
    readout,
    save,
  );
  const nothing = element('p.quiet', 'The model has no faces, so there are no angles.');
  panel.replaceChildren(plot, nothing);

  let shown: { original: number[]; now: number[] } | null = null;

  const newest = newestOnly(() => store.get().model);
  const update = throttled(EVERY_MS, async () => {
    const { model } = store.get();
    plot.hidden = !model?.faces;
    nothing.hidden = !plot.hidden;
    if (panel.offsetParent === null || plot.hidden) return;
    const found = await newest(actions.reportErrors(actions.ask.angles()));
    if (found) draw(found);
  });

  function draw(found: { original: number[]; now: number[] }) {
    shown = found;
    const { original, now } = found;
    const most = Math.max(...original, ...now, 1);
    if (bars.childElementCount !== now.length + 1)
      bars.replaceChildren(...now.map(() => element('i')), before);
    now.forEach((count, k) => {
      const bar = bars.children[k] as HTMLElement;
      bar.style.height = count > 0 ? `max(1px, ${(100 * count) / most}%)` : '0';
    });
    drawOutline(before, original, most);
    setText(key.lastElementChild as HTMLElement, `${groupDigits(most)} corners`);
    const all = now.reduce((sum, count) => sum + count, 0);
    const words = (counts: number[]) => {
      const [from, to] = middleHalf(counts).map((bin) => (bin * HALF_TURN) / counts.length);
      return `${from}° to ${to}°`;
    };
    bars.ariaLabel = `${groupDigits(all)} corners by angle. The middle half: originally ${words(original)}, now ${words(now)}`;
    setText(readout, `The middle half: ${words(original)}, now ${words(now)}`);
  }

  bars.addEventListener('pointermove', ({ clientX }) => {
    if (!shown) return;
    const { left, width } = bars.getBoundingClientRect();
    const { length } = shown.now;
    const bin = Math.min(Math.max(Math.floor(((clientX - left) / width) * length), 0), length - 1);
    const bound = (k: number) => (k * HALF_TURN) / length;
    setText(
      readout,
      `${bound(bin)}° to ${bound(bin + 1)}°: ${groupDigits(shown.original[bin])}, now ${groupDigits(shown.now[bin])}`,
    );
  });
  bars.addEventListener('pointerleave', () => shown && draw(shown));
  solver.on('frame', update);
  // Updates the panel when it becomes visible.
  new ResizeObserver(update).observe(panel);
  update();
}

/**
 * Returns the range of bins with the middle half of the counts.
 * @returns the start of the first and the end of the last
 */
function middleHalf(counts: number[]): [number, number] {
  const all = counts.reduce((sum, count) => sum + count, 0);
  const binOf = (part: number) => {
    let sum = 0;
    return counts.findIndex((count) => (sum += count) >= part * all && count > 0);
  };
  return [binOf(0.25), binOf(0.75) + 1];
}
