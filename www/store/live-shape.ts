/** What features that follow a moving shape share. */

/** Features that compute much for each shape follow larger meshes only at rest. */
export const MOST_LIVE_VERTICES = 3000;

/** Returns a checksum by which a shape, or its connectivity, is compared with an earlier one. */
export function checksum(numbers: Float64Array | Uint32Array) {
  let sum = 0;
  for (let i = 0; i < numbers.length; i++) sum += numbers[i] * ((i % 7) + 1);
  return sum;
}
