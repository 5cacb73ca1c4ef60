/** The convergence plot: energies over iterations, on a logarithmic scale, with uPlot. */

import uPlot from 'uplot';
import { colourOf, element, setText } from '../dom.ts';
import { groupDigits, number, powerOfTen } from '../words.ts';
import { DECADES, SERIES } from './energies.ts';
import { tickExponents } from './ticks.ts';

const HEIGHT = 180;
/** Tick increments for counts. */
const COUNTS = [1, 10, 100, 1000, 1e4, 1e5].flatMap((power) => [power, 2 * power, 5 * power]);

export class EnergyPlot {
  #place;
  #key;
  #plot: uPlot | null = null;
  #columns: number[][] = [];
  #units = '';
  #observer;

  constructor(place: HTMLElement) {
    this.#place = place;
    this.#key = element('div.plot-key');
    this.#observer = new ResizeObserver(() => {
      const width = this.#place.clientWidth;
      if (this.#plot && width > 0 && width !== this.#plot.width) {
        this.#plot.setSize({ width, height: HEIGHT });
      }
    });
    this.#observer.observe(place);
  }

  /**
   * @param columns iteration, then one per series
   * @param units of the energies
   */
  show(columns: number[][], units: string) {
    this.#columns = columns;
    this.#units = units;
    if (this.#plot) this.#plot.setData(this.#drawable());
    else this.#make();
    this.#writeKey(columns[0].length - 1);
  }

  /** Redraws after a change of theme: uPlot paints on a canvas, without style sheets. */
  restyle() {
    if (!this.#plot) return;
    this.#make();
  }

  destroy() {
    this.#observer.disconnect();
    this.#plot?.destroy();
    this.#plot = null;
  }

  /**
   * Returns the columns with values too small for the logarithmic scale raised to its lower end.
   */
  #drawable() {
    let [greatest, smallest] = [0, Infinity];
    for (const column of this.#columns.slice(1)) {
      for (let i = 0; i < column.length; i++) {
        greatest = Math.max(greatest, column[i]);
        // A term that is only rounding error at the start would take up most of the scale.
        if (i > 0 && column[i] > 0) smallest = Math.min(smallest, column[i]);
      }
    }
    smallest = Math.min(smallest, greatest);
    const least = Math.max(smallest, greatest * 10 ** -DECADES) || Number.MIN_VALUE;
    const [iterations, ...energies] = this.#columns;
    return [
      iterations,
      // A term that is always zero has no line.
      ...energies.map((column) =>
        column.some((value) => value > 0)
          ? column.map((value) => Math.max(value, least))
          : column.map(() => null),
      ),
    ] as uPlot.AlignedData;
  }

  #make() {
    this.#plot?.destroy();
    this.#plot = new uPlot(
      {
        width: Math.max(this.#place.clientWidth, 120),
        height: HEIGHT,
        padding: [8, 20, 0, 0],
        legend: { show: false },
        cursor: { y: false, points: { size: 5 }, drag: { x: false, y: false } },
        scales: { x: { time: false }, y: { distr: 3 } },
        axes: axesOf(this.#place),
        series: [
          {},
          ...SERIES.map(({ id, label, width }) => ({
            label,
            stroke: colourOf(this.#place, `--series-${id}`),
            width,
            points: { show: false },
          })),
        ],
        hooks: {
          setCursor: [
            (plot) => this.#writeKey(plot.cursor.idx ?? (this.#columns[0]?.length ?? 1) - 1),
          ],
        },
      },
      this.#drawable(),
      this.#place,
    );
    this.#place.append(this.#key);
  }

  /**
   * Writes the key: the lines and their values at the cursor.
   * @param index of an iteration
   */
  #writeKey(index: number) {
    if (this.#key.childElementCount === 0) {
      this.#key.append(
        element('span.quiet'),
        ...SERIES.map(({ id, label }) =>
          element(
            'span',
            { title: label },
            element('span.swatch', { style: `--chip: var(--series-${id})` }),
            element('span.figure'),
          ),
        ),
      );
    }
    const [iterations, ...energies] = this.#columns;
    const unit = this.#units ? `, in ${this.#units}` : '';
    setText(this.#key.children[0], `Iteration ${iterations[index] ?? 0}${unit}`);
    SERIES.forEach(({ label }, i) => {
      const cell = this.#key.children[i + 1].lastElementChild;
      if (cell) setText(cell, `${label} ${number(energies[i][index] ?? 0)}`);
    });
  }
}

/**
 * Returns the axes: iterations, and energies on a logarithmic scale.
 * @param place of the plot
 */
function axesOf(place: HTMLElement): uPlot.Axis[] {
  const common = {
    stroke: colourOf(place, '--quiet'),
    font: `11px ${getComputedStyle(place).fontFamily}`,
    grid: { stroke: colourOf(place, '--line'), width: 1 },
    ticks: { show: false },
    gap: 4,
  };
  return [
    {
      ...common,
      size: 22,
      space: 48,
      incrs: COUNTS,
      values: (_, ticks) => ticks.map(groupDigits),
    },
    {
      ...common,
      size: 46,
      filter: (_, ticks) => ticks,
      splits: (_, _axis, least, most) => decades(least, most),
      values: (_, ticks) => ticks.map(powerOfTen),
    },
  ];
}

/** Returns at most about six powers of ten. */
function decades(least: number, most: number) {
  const first = Math.ceil(Math.log10(least) - 1e-9);
  const last = Math.floor(Math.log10(most) + 1e-9);
  return tickExponents(first, last).map((exponent) => 10 ** exponent);
}
