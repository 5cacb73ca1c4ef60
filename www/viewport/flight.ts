/** Cameras between two others, as the numbers that the view returns and restores. */

/**
 * Places of the numbers of a camera (`View.camera`), after the three of its pivot: distance, turn and
 * tilt in radians, and whether the model is framed, 0 or 1.
 */
export const [DISTANCE, TURN, TILT, FRAMED] = [3, 4, 5, 6];
const WHOLE = 2 * Math.PI;

/**
 * Returns the camera after a part of the way, from 0 to 1, with easing: it turns the shorter way
 * round, and its distance changes by equal factors. What frames the model meanwhile leaves it alone.
 */
export function between(from: Float64Array, to: Float64Array, part: number): Float64Array {
  const eased = part * part * (3 - 2 * part);
  const camera = from.map((start, k) => start + eased * (to[k] - start));
  const turn = to[TURN] - from[TURN];
  const shorter = turn - WHOLE * Math.round(turn / WHOLE);
  camera[DISTANCE] = from[DISTANCE] * (to[DISTANCE] / from[DISTANCE]) ** eased;
  camera[TURN] = from[TURN] + eased * shorter;
  camera[FRAMED] = 0;
  return camera;
}

/** Whether the user has moved the camera; to frame the model is not a move. */
export const isMoved = (camera: Float64Array, before: Float64Array) =>
  camera[FRAMED] === 0 && camera.some((value, k) => value !== before[k]);
