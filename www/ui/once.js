/** What a page has one of, made when it is first needed. */

/**
 * Returns a function that makes something at its first call and returns the same at later ones.
 * @template {unknown[]} Arguments
 * @template Made
 * @param {(...values: Arguments) => Made} make
 * @returns {(...values: Arguments) => Made}
 */
export function once(make) {
  /** @type {Made | undefined} */
  let made;
  return (...values) => (made ??= make(...values));
}
