/**
 * Whether the wasm machine has trapped: what it holds cannot be used any more. Other errors leave it as
 * it was, also a RangeError of the page's own. One that passes through the machine is its stack overflow,
 * or cut it off in the middle of its work.
 * @param {unknown} thrown
 */
export function isTrap(thrown) {
  if (thrown instanceof WebAssembly.RuntimeError) return true;
  return thrown instanceof RangeError && /\bwasm-function\b/.test(thrown.stack ?? '');
}
