/** Common settings of the axes of all plots. */

import { colourOf } from '../dom.ts';
import type { Axis } from 'uplot';

/**
 * Returns the axes of a plot for uPlot.
 * @param place of the plot
 * @param x settings of the x axis
 * @param marks positions of ticks on the y axis
 * @param words labels of the ticks
 */
export function axesOf(
  place: HTMLElement,
  x: Axis,
  marks: (least: number, most: number) => number[],
  words: (value: number) => string,
): Axis[] {
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
