/** A plot of an experiment: one line for each method, the values on a logarithmic scale, with uPlot. */

import uPlot from 'uplot';
import { decades, powerOfTen } from '../plot.js';

const HEIGHT = 240;

/**
 * @typedef {object} Axes
 * @property {string} label of the whole plot, for those who cannot see it
 * @property {string[]} names of the methods
 * @property {number | null} x the column that is drawn over; null for the iterations
 * @property {number} y the column that is drawn
 */

export class Chart {
  #place;
  #axes;
  #plot;
  #observer;

  /**
   * @param {HTMLElement} place
   * @param {Axes} axes
   */
  constructor(place, axes) {
    this.#place = place;
    this.#axes = axes;
    this.#plot = this.#make();
    this.#plot.root.setAttribute('role', 'img');
    this.#plot.root.setAttribute('aria-label', axes.label);
    this.#observer = new ResizeObserver(() => {
      const width = place.clientWidth;
      if (width > 0 && width !== this.#plot.width) this.#plot.setSize({ width, height: HEIGHT });
    });
    this.#observer.observe(place);
  }

  /** @param {number[][][]} methods the columns of those that have started */
  show(methods) {
    const { x, y, names } = this.#axes;
    const tables = names.map((_, k) => {
      const columns = methods[k];
      if (!columns) return /** @type {uPlot.AlignedData} */ ([[], []]);
      const over = x === null ? columns[y].map((_, iteration) => iteration) : columns[x];
      // A logarithm has no zero.
      const values = columns[y].map((value) => (value > 0 ? value : null));
      return /** @type {uPlot.AlignedData} */ ([over, values]);
    });
    this.#plot.setData(uPlot.join(tables));
  }

  destroy() {
    this.#observer.disconnect();
    this.#plot.destroy();
  }

  #make() {
    const style = getComputedStyle(this.#place);
    const colour = (/** @type {string} */ name) => style.getPropertyValue(name).trim();
    const axis = {
      stroke: colour('--quiet'),
      font: `11px ${style.fontFamily}`,
      grid: { stroke: colour('--line'), width: 1 },
      ticks: { show: false },
    };
    return new uPlot(
      {
        width: Math.max(this.#place.clientWidth, 200),
        height: HEIGHT,
        padding: [8, 8, 0, 0],
        legend: { show: false },
        cursor: { y: false, points: { size: 5 }, drag: { x: false, y: false } },
        scales: { x: { time: false }, y: { distr: 3 } },
        axes: [
          {
            ...axis,
            size: 22,
            gap: 4,
            space: 56,
            values: (_, ticks) => ticks.map((tick) => String(Number(tick.toPrecision(6)))),
          },
          {
            ...axis,
            size: 46,
            gap: 4,
            filter: (_, ticks) => ticks,
            splits: (_, _axis, least, most) => decades(least, most),
            values: (_, ticks) => ticks.map(powerOfTen),
          },
        ],
        series: [
          {},
          ...this.#axes.names.map((label, k) => ({
            label,
            stroke: colour(`--line-of-method-${k}`),
            width: 1.75,
            points: { show: false },
            // Lines have points at different times.
            spanGaps: true,
          })),
        ],
      },
      [[], ...this.#axes.names.map(() => [])],
      this.#place,
    );
  }
}
