// Fabrication parts and sheets, natively and in the page's module for them.

import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { buildModule } from '../wasm.mjs';
import { at } from '../project.mjs';
import { say } from '../run.mjs';
import { quadsOf } from './problems.mjs';
import { median } from './statistics.mjs';

const ROUNDS = 5;
const medianOfEach = (times) =>
  Object.fromEntries(Object.entries(times).map(([key, all]) => [key, median(all)]));

/** Returns a row per number of panels and place. */
export async function measureParts({ panels, where, native, trial }) {
  const rounds = trial ? 1 : ROUNDS;
  const module = where.includes('browser') ? await moduleOfParts() : null;
  const rows = [];
  for (const count of panels) {
    const quads = quadsOf((Math.round(Math.sqrt(count)) + 1) ** 2);
    const row = { panels: quads.offsets.length - 1 };
    say(`parts of ${row.panels} panels`);
    if (where.includes('native')) {
      const times = await native.perform({ measure: 'parts', mesh: quads.mesh, rounds });
      rows.push({ ...row, where: 'native', ...medianOfEach(times) });
    }
    if (module) {
      rows.push({ ...row, where: 'WebAssembly', ...medianOfEach(partsOf(module, quads, rounds)) });
    }
  }
  return rows;
}

/** The module as shipped; Node.js has the engine of Chromium. */
async function moduleOfParts() {
  await buildModule('build');
  const folder = at('www', 'pkg', 'build');
  const module = await import(pathToFileURL(`${folder}/shape_up.js`));
  module.initSync({ module: readFileSync(`${folder}/shape_up_bg.wasm`) });
  return module;
}

function partsOf({ Builder, buildOffers }, { positions, offsets, indices }, rounds) {
  const times = { build: [], fins: [], paper: [], axes: [], distance: [], sheets: [], files: [] };
  const timed = (key, run) => {
    const started = performance.now();
    const value = run();
    times[key].push(performance.now() - started);
    return value;
  };
  const { defaults } = buildOffers();
  const builderOf = (product) =>
    new Builder(positions, offsets, indices, { ...defaults, product }, 'm', 1);
  for (let round = 0; round < rounds; round++) {
    timed('fins', () => builderOf('fins')).free();
    timed('paper', () => builderOf('paper')).free();
    const builder = timed('build', () => builderOf('panels'));
    timed('axes', () => builder.choices());
    timed('distance', () => {
      builder.moveLayer(0.1);
      return [builder.report(), builder.layer()];
    });
    timed('sheets', () => builder.sheets(0, 10_000));
    timed('files', () => builder.files());
    builder.free();
  }
  return times;
}
