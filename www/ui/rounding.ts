/**
 * Rounding errors shown as zero. Sixteen digits of a coordinate leave errors of about 1e-16 of the
 * size of the mesh, and sums over its vertices somewhat more; such values are displayed as 0.
 */

/**
 * Lengths below this fraction of the size are rounding errors, as are energies below its square.
 */
export const ROUNDING = 1e-12;

/**
 * @param value a length, in units of the mesh
 * @param size of the mesh
 */
export function lengthOrZero(value: number, size: number) {
  return value < ROUNDING * size ? 0 : value;
}

/**
 * @param value an energy, in square units of the mesh
 * @param size of the mesh
 */
export function energyOrZero(value: number, size: number) {
  return value < (ROUNDING * size) ** 2 ? 0 : value;
}
