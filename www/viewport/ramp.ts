/** Colour ramp of the displayed range, for legends. */

import type { Viewport } from './viewport.ts';

/**
 * Returns the colours of the ramp with their positions from 0 to 1: continuous, or in sharp bands.
 */
export function rampStops(viewport: Viewport): [number, string][] {
  const stops = viewport.unmeasured((view) => {
    const colours = view.rampColours();
    const limits = view.bandLimits();
    const ends = [0, ...limits, 1];
    return colours.flatMap((colour, i) =>
      (limits.length > 0 ? [ends[i], ends[i + 1]] : [i / (colours.length - 1)]).map(
        (at) => [at, colour] as [number, string],
      ),
    );
  });
  return stops ?? [];
}

/**
 * Returns the ramp as a CSS background.
 * @param ends positions of the range's ends, in per cent of the width
 * @param neutral end of the part where faces keep their material, in per cent of the width
 */
export function rampOf(viewport: Viewport, [from, to]: [number, number], neutral: number) {
  const spaced = rampStops(viewport).map(([at, colour]) => `${colour} ${from + (to - from) * at}%`);
  const ramp = `linear-gradient(to right, ${spaced.join(', ')})`;
  const material = `linear-gradient(to right, var(--material) ${neutral}%, transparent 0)`;
  return neutral > 0 ? `${material}, ${ramp}` : ramp;
}
