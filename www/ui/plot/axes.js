/** Common settings of the axes of all plots. */

import { colourOf } from '../dom.js';

/**
 * Returns the axes of a plot for uPlot.
 * @param {HTMLElement} place of the plot
 * @param {import("uplot").Axis} x settings of the x axis
 * @param {(least: number, most: number) => number[]} marks positions of ticks on the y axis
 * @param {(value: number) => string} words labels of the ticks
 * @returns {import("uplot").Axis[]}
 */
export function axesOf(place, x, marks, words) {
  const common = {
    stroke: colourOf(place, '--quiet'),
    font: `11px ${getComputedStyle(place).fontFamily}`,
    grid: { stroke: colourOf(place, '--line'), width: 1 },
    ticks: { show: false },
    gap: 4,
  };
  return [
    { ...common, size: 22, ...x },
    {
      ...common,
      size: 46,
      filter: (_, ticks) => ticks,
      splits: (_, _axis, least, most) => marks(least, most),
      values: (_, ticks) => ticks.map(words),
    },
  ];
}
