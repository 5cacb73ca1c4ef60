// node .scripts/modules.mjs [<feature> ...]: builds modules of the page, or all, in www/pkg/.

import { main, Problem } from './run.mjs';
import { buildModules, modules } from './wasm.mjs';

await main(async () => {
  const wanted = process.argv.slice(2);
  const unknown = wanted.find((feature) => !modules.includes(feature));
  if (unknown) throw new Problem(`${unknown} is no module: ${modules.join(', ')}`);
  await buildModules(wanted.length > 0 ? wanted : modules);
});
