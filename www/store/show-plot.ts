/** The region of plots and lists, shown at one of them. */

import { byId } from '../ui/dom.ts';
import { reveal } from '../ui/reveal.ts';
import type { Actions } from './actions.ts';

/** @param plot id of a plot or list, whose step may be closed */
export async function showPlot({ look }: Pick<Actions, 'look'>, plot: string) {
  look({ plot });
  await Promise.resolve();
  reveal(byId('analysis'));
}
