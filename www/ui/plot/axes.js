/** What the axes of all plots have in common. */

import { colourOf } from '../dom.js';

/**
 * The axes of a plot, as uPlot takes them.
 * @param {HTMLElement} place of the plot
 * @param {import("uplot").Axis} x what is particular about it
 * @param {(least: number, most: number) => number[]} marks where the other one has lines
 * @param {(value: number) => string} words what is written there
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
