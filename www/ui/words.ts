/**
 * Numbers, lengths and counts in words, as the engine writes them (`src/words`): a module of Rust small
 * enough to be there before anything is shown. What imports this waits for it.
 */

import init from '../pkg/words/shape_up.js';

await init();

export * from '../pkg/words/shape_up.js';
