// node examples/solve.mjs roof.obj out.obj: makes the panels of a mesh circular.

import { readFileSync, writeFileSync } from 'node:fs';
import { basename } from 'node:path';
import { load, Solver } from 'shape-up-engine';

const [input, output] = process.argv.slice(2);
await load();
const solver = new Solver();
const { meanEdge } = solver.load(basename(input), readFileSync(input));
solver.makePanels('circle', 1e-4 * meanEdge, 'now');
while (!solver.step());
solver.endRun();
writeFileSync(output, solver.obj());
console.log(solver.verdict().words);
