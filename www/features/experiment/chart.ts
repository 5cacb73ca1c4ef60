/** A plot of an experiment with uPlot: one line for each method, on a logarithmic value axis. */

import uPlot from 'uplot';
import { colourOf } from '../../ui/dom.ts';
import { axesOf } from '../../ui/plot/axes.ts';
import { PRINTED, type Line } from '../../ui/plot/lines-svg.ts';
import { COUNTS, decades, powerOfTen } from '../../ui/plot/plot.ts';

const HEIGHT = 240;
/** While the dialog is open, only the system can change the theme. */
const SYSTEM = matchMedia('(prefers-color-scheme: dark)');

interface Axes {
  /** of the whole plot, for screen readers */
  label: string;
  /** of the methods */
  names: string[];
  /** column of the horizontal axis; null for the iteration number */
  x: number | null;
  /** column of the values */
  y: number;
  /** whether the lowest value of all methods is subtracted */
  aboveLowest: boolean;
}

export class Chart {
  #place;
  #axes;
  #plot;
  #observer;
  #data: uPlot.AlignedData | null = null;
  /** Per method, the horizontal positions and the values. */
  #lines: [number[], number[]][] = [];

  constructor(place: HTMLElement, axes: Axes) {
    this.#place = place;
    this.#axes = axes;
    this.#plot = this.#make();
    this.#observer = new ResizeObserver(() => {
      const width = place.clientWidth;
      if (width > 0 && width !== this.#plot.width) this.#plot.setSize({ width, height: HEIGHT });
    });
    this.#observer.observe(place);
    SYSTEM.addEventListener('change', this.#restyle);
  }

  /** @param methods columns of the methods that have started */
  show(methods: number[][][]) {
    const { x, y, names, aboveLowest } = this.#axes;
    const all = methods.map((columns) => columns?.[y] ?? []);
    const lowest = aboveLowest ? all.flat().reduce((a, b) => Math.min(a, b), Infinity) : 0;
    this.#lines = names.map((_, k) => {
      const columns = methods[k];
      if (!columns) return [[], []];
      const over = x === null ? columns[y].map((_, iteration) => iteration) : columns[x];
      return [over, columns[y].map((value) => value - lowest)];
    });
    const tables = this.#lines.map(([over, values]) => {
      // Zero has no logarithm.
      const drawn = values.map((value) => (value > 0 ? value : null));
      return [over, drawn] as uPlot.AlignedData;
    });
    this.#data = uPlot.join(tables);
    this.#plot.setData(this.#data);
  }

  /** The lines in the colours for print. */
  lines(): Line[] {
    return this.#lines.map(([x, y], k) => ({
      label: this.#axes.names[k],
      colour: PRINTED[k % PRINTED.length],
      x,
      y,
      width: 1.5,
    }));
  }

  /** uPlot paints on a canvas, which style sheets do not reach. */
  #restyle = () => {
    this.#plot.destroy();
    this.#plot = this.#make();
    if (this.#data) this.#plot.setData(this.#data);
  };

  destroy() {
    SYSTEM.removeEventListener('change', this.#restyle);
    this.#observer.disconnect();
    this.#plot.destroy();
  }

  #make() {
    const plot = new uPlot(
      {
        width: Math.max(this.#place.clientWidth, 200),
        height: HEIGHT,
        padding: [8, 16, 0, 0],
        legend: { show: false },
        cursor: { y: false, points: { size: 5 }, drag: { x: false, y: false } },
        scales: { x: { time: false }, y: { distr: 3, range } },
        axes: axesOf(
          this.#place,
          {
            space: 56,
            ...(this.#axes.x === null && { incrs: COUNTS }),
            values: (_, ticks) => ticks.map((tick) => String(Number(tick.toPrecision(6)))),
          },
          marks,
          written,
        ),
        series: [
          {},
          ...this.#axes.names.map((label, k) => ({
            label,
            stroke: colourOf(this.#place, `--line-of-method-${k}`),
            width: 1.75,
            points: { show: false },
            // The methods are sampled at different times.
            spanGaps: true,
          })),
        ],
      },
      [[], ...this.#axes.names.map(() => [])],
      this.#place,
    );
    plot.root.setAttribute('role', 'img');
    plot.root.setAttribute('aria-label', this.#axes.label);
    return plot;
  }
}

/** The smallest range that contains the values. */
function range(_: uPlot, least: number | null, most: number | null): uPlot.Range.MinMax {
  if (least === null || most === null) return [null, null];
  return uPlot.rangeLog(least, most, 10, false);
}

/** Tick values: powers of ten; if there are at most two, also twice and five times these. */
function marks(least: number, most: number) {
  const powers = decades(least, most);
  if (powers.length > 2) return powers;
  const first = 10 ** Math.floor(Math.log10(least) + 1e-9);
  return COUNTS.map((count) => first * count).filter((mark) => mark >= least && mark <= most);
}

function written(mark: number) {
  return mark >= 1e-3 && mark < 1e4 ? String(Number(mark.toPrecision(1))) : powerOfTen(mark);
}
