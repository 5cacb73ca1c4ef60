/** Colour ramp of the displayed range, for legends. */

/**
 * Returns the colours of the ramp with their positions from 0 to 1: continuous, or in sharp bands.
 * @param {import("./viewport.js").Viewport} viewport
 * @param {number} [side] of a split view: 0 left, 1 right
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
 * Returns the ramp as a CSS background.
 * @param {import("./viewport.js").Viewport} viewport
 * @param {[number, number]} ends positions of the range's ends, in per cent of the width
 * @param {{ side?: number, neutral?: number }} [options] side of a split view; end of the part
 *   where faces keep their material, in per cent of the width
 */
export function rampOf(viewport, [from, to], { side, neutral = 0 } = {}) {
  const spaced = rampStops(viewport, side).map(
    ([at, colour]) => `${colour} ${from + (to - from) * at}%`,
  );
  const ramp = `linear-gradient(to right, ${spaced.join(', ')})`;
  const material = `linear-gradient(to right, var(--material) ${neutral}%, transparent 0)`;
  return neutral > 0 ? `${material}, ${ramp}` : ramp;
}
