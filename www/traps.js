/**
 * Whether the wasm machine has trapped: what it holds cannot be used any more. Other errors leave it as
 * it was.
 * @param {unknown} thrown
 */
export function isTrap(thrown) {
  return thrown instanceof WebAssembly.RuntimeError || thrown instanceof RangeError;
}
