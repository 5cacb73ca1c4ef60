// node .scripts/modules.mjs [--declarations] [<feature> ...]: builds modules of the page, or all, in
// www/pkg/; `--declarations`: only those whose types may have changed.

import { main, Problem } from './run.mjs';
import { buildDeclarations, buildModules, modules } from './wasm.mjs';

await main(async () => {
  const words = process.argv.slice(2);
  const wanted = words.filter((word) => word !== '--declarations');
  const unknown = wanted.find((feature) => !modules.includes(feature));
  if (unknown) throw new Problem(`${unknown} is no module: ${modules.join(', ')}`);
  const build = words.includes('--declarations') ? buildDeclarations : buildModules;
  await build(wanted.length > 0 ? wanted : modules);
});
