/** The colours of the range as a legend paints them: gradual, or in bands with hard limits. */

/**
 * Colours with their places in the range, from 0 to 1.
 * @param {import("./viewport.js").Viewport} viewport
 * @returns {[number, string][]}
 */
export function rampStops(viewport) {
  return (
    viewport.with((view) => {
      const colours = view.rampColours();
      const limits = [...view.bandLimits()];
      if (limits.length === 0)
        return colours.map((colour, i) => stop(i / (colours.length - 1), colour));
      const ends = [0, ...limits, 1];
      return colours.flatMap((colour, i) => [stop(ends[i], colour), stop(ends[i + 1], colour)]);
    }) ?? []
  );
}

/** @type {(at: number, colour: string) => [number, string]} */
const stop = (at, colour) => [at, colour];
