/**
 * Numbers, lengths and counts in words: a small module of Rust (`src/words`) on the page's thread, so
 * that what follows the hand is written at once. What imports this waits for it; a page fetches it
 * beside its scripts.
 */

import init from '../pkg/words/shape_up.js';

await init().catch((thrown: unknown) => {
  // Not missing, but nothing that this browser can compile.
  if (thrown instanceof WebAssembly.CompileError) throw thrown;
  throw new Error('a part of the page could not be fetched');
});

export * from '../pkg/words/shape_up.js';
