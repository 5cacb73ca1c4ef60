/** What a page has one of, made when it is first needed. */

/** Returns a function that makes something at its first call and returns the same at later ones. */
export function once<Arguments extends unknown[], Made>(
  make: (...values: Arguments) => Made,
): (...values: Arguments) => Made {
  let made: Made | undefined;
  return (...values) => (made ??= make(...values));
}
