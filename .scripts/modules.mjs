// Builds the WebAssembly modules of the page in www/pkg/.

import { main } from './run.mjs';
import { buildModules } from './wasm.mjs';

await main(buildModules);
