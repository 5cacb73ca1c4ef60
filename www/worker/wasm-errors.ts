/**
 * Whether the wasm instance has trapped, which makes its state unusable. Other errors leave it
 * intact, including a RangeError of the page's own code; but one with wasm frames on its stack is
 * an overflow of the stack in wasm, or interrupted wasm in the middle of its work.
 */
export function isTrap(thrown: unknown) {
  if (thrown instanceof WebAssembly.RuntimeError) return true;
  return thrown instanceof RangeError && /\bwasm-function\b/.test(thrown.stack ?? '');
}
