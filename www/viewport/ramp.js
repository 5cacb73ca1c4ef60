/** The colours of the range as legends paint them. */

/**
 * The colours of the range as a legend paints them, with their places in it from 0 to 1: gradual, or
 * in bands with hard limits.
 * @param {import("./viewport.js").Viewport} viewport
 * @param {number} [side] of two pictures, 0 left or 1 right
 * @returns {[number, string][]}
 */
export function rampStops(viewport, side) {
  const stops = viewport.unmeasured((view) => {
    const colours = view.rampColours(side);
    const limits = view.bandLimits(side);
    const ends = [0, ...limits, 1];
    return colours.flatMap((colour, i) =>
      (limits.length > 0 ? [ends[i], ends[i + 1]] : [i / (colours.length - 1)]).map(
        (at) => /** @type {[number, string]} */ ([at, colour]),
      ),
    );
  });
  return stops ?? [];
}

/**
 * The same as a CSS background.
 * @param {import("./viewport.js").Viewport} viewport
 * @param {[number, number]} ends of the range, in per cent of the width
 * @param {{ side?: number, neutral?: number }} [options] of two pictures the side; up to where the
 *   faces keep the material, in per cent of the width
 */
export function rampOf(viewport, [from, to], { side, neutral = 0 } = {}) {
  const spaced = rampStops(viewport, side).map(
    ([at, colour]) => `${colour} ${from + (to - from) * at}%`,
  );
  const ramp = `linear-gradient(to right, ${spaced.join(', ')})`;
  const material = `linear-gradient(to right, var(--material) ${neutral}%, transparent 0)`;
  return neutral > 0 ? `${material}, ${ramp}` : ramp;
}
