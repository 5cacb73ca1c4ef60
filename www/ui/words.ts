/**
 * Numbers, lengths and counts in words: a small module of Rust (`src/words`) on the page's thread, so
 * that what follows the hand is written at once. What imports this waits for it; a page fetches it
 * beside its scripts.
 */

import init from '../pkg/words/shape_up.js';

await init().catch((thrown: unknown) => {
  const isMissing = thrown instanceof TypeError || String(thrown).includes('failed to fetch Wasm');
  throw isMissing ? new Error('a part of the page could not be fetched') : thrown;
});

export * from '../pkg/words/shape_up.js';
