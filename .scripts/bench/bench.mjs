// npm run bench: the speed of the solver, natively and in headless Chromium, compared with the
// limit of the machine and with other libraries. `npm run bench -- --help` lists the options.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus, loadavg } from 'node:os';
import { join } from 'node:path';
import { build as buildSite } from '../build.mjs';
import { main, outputOf, Problem, say } from '../run.mjs';
import { setUp } from '../setup.mjs';
import { measureExact, measureExactPeers } from './exact/measure.mjs';
import { browserSolver, buildBenchModule } from './in-browser.mjs';
import { measureLook } from './look.mjs';
import {
  mapSizes,
  measureConvergence,
  measureFactors,
  measureIterations,
  measureMaps,
  measureModels,
  measureOperators,
} from './measure.mjs';
import { nativeSolver } from './native.mjs';
import { optionsOf, usage } from './options.mjs';
import { measureParts } from './parts.mjs';
import { comparisons, measurePeer, setUpPeers } from './peers.mjs';
import { benchFolder } from './problems.mjs';
import { writeReadme } from './readme.mjs';
import { measureStart } from './start.mjs';
import { markdown } from './tables.mjs';

/** Numbers of panels for the fabrication benchmark. */
const PANELS = [1000, 3000, 10_000];
/** Size of the ten models opened in turn, unless the largest measured size is smaller. */
const MODELS_SIZE = 10_000;

/** Parts of the benchmark that measure the page or its view, not the solver. */
const WITHOUT_SOLVER = new Set(['start', 'look']);

/** Builds what is measured in the browser, as it is shipped. */
async function build({ where, parts, trial }) {
  if (!where.includes('browser')) return;
  await setUp({ checks: true });
  await buildSite();
  const needed = (parts.has('iterations') && !trial) || parts.has('operators');
  if (needed) await buildBenchModule();
}

function machine(words) {
  const [{ model }] = cpus();
  return {
    command: ['npm run bench', words.length ? `-- ${words.join(' ')}` : ''].join(' ').trim(),
    date: new Date().toISOString().slice(0, 10),
    processor: model,
    cores: cpus().length,
    rustc: outputOf('rustc', ['--version']),
    commit: outputOf('git', ['rev-parse', '--short', 'HEAD']),
    /** Running programs that wanted a core before the benchmark began. */
    load: loadavg()[0],
  };
}

async function measurePeers(options, places) {
  const peers = setUpPeers();
  const rows = [];
  for (const comparison of comparisons) {
    for (const size of options.sizes) {
      const { peer, problem, what } = comparison;
      const there = peers[peer].version !== undefined;
      if (there) say(`${peer}, ${what}, ${size} vertices`);
      const theirs = there ? measurePeer(comparison, size) : { reason: peers[peer].reason };
      const asked = { sizes: [size], letters: [problem], places, trial: options.trial };
      const ours = there && theirs.ms !== undefined ? await measureOurs(asked) : [];
      rows.push({ ...comparison, version: peers[peer].version ?? null, size, theirs, ours });
    }
  }
  return rows;
}

/** Returns our own milliseconds for a peer's task, as { where, accelerator, ms }. */
async function measureOurs(asked) {
  const steps = await measureIterations(asked);
  const maps = await measureMaps(asked);
  const ms = steps.map(({ where, accelerator, step }) => ({
    where,
    accelerator,
    ms: step.total.median,
  }));
  return [...ms, ...maps.map(({ where, total }) => ({ where, accelerator: null, ms: total }))];
}

/** Returns where problems can be measured, as far as requested: { places, native, browser }. */
async function placesOf({ where, trial, parts }) {
  if ([...parts].every((part) => WITHOUT_SOLVER.has(part)))
    return { places: {}, native: null, browser: null };
  const native = await nativeSolver(trial ? 'dev' : 'release');
  const inNative = {
    perform: native,
    stream: async (bytes) => (await native({ measure: 'stream', bytes: [bytes] }))[0],
  };
  const browser = where.includes('browser') ? await browserSolver() : null;
  const inBrowser = browser && {
    perform: browser.perform,
    run: browser.run,
    stream: async (bytes) =>
      browser.canStream()
        ? (await browser.perform({ measure: 'stream', bytes: [bytes] }))[0]
        : null,
  };
  const places = {
    ...(where.includes('native') ? { native: inNative } : {}),
    ...(inBrowser ? { browser: inBrowser } : {}),
  };
  return { places, native: inNative, browser };
}

async function measure(options, words) {
  const { sizes, problems: letters, limitMs, full, trial } = options;
  const results = { machine: machine(words), sizes, failed: {} };
  await build(options);
  const { places, native, browser } = await placesOf(options);
  if (browser) results.machine.browser = browser.version;
  const inBrowser = options.where.includes('browser');
  const asked = { sizes, letters, places, native, limitMs, trial };
  /** Each part of the benchmark adds its results. */
  const measures = {
    async iterations() {
      results.iterations = await measureIterations(asked);
      results.maps = await measureMaps({ ...asked, sizes: mapSizes(sizes) });
    },
    async factors() {
      if (browser) results.factors = await measureFactors(browser, trial);
    },
    async convergence() {
      results.convergence = await measureConvergence(asked);
    },
    async memory() {
      const size = Math.min(MODELS_SIZE, Math.max(...sizes));
      if (browser) results.models = await measureModels(browser, size);
    },
    async start() {
      if (inBrowser) results.start = await measureStart(full ? 5 : 3);
    },
    async build() {
      const panels = trial ? [100] : PANELS;
      results.parts = await measureParts({ panels, where: options.where, native, trial });
    },
    async exact() {
      results.exact = await measureExact({ places, trial });
      if (options.parts.has('peers')) results.exactPeers = measureExactPeers({ trial });
    },
    async operators() {
      results.operators = await measureOperators({ browser, native: places.native });
    },
    async look() {
      if (inBrowser) results.look = await measureLook({ trial });
    },
    async peers() {
      results.peers = await measurePeers(options, places);
    },
  };
  for (const part of options.parts) {
    try {
      await measures[part]();
    } catch (error) {
      // Keep the earlier measurements, which took long.
      console.error(error);
      results.failed[part] = String(error.message ?? error);
    }
  }
  await browser?.close();
  results.machine.loadAfter = loadavg()[0];
  return results;
}

await main(async () => {
  const words = process.argv.slice(2);
  const options = optionsOf(words);
  if (options.help) return console.log(usage);
  const results = options.from
    ? JSON.parse(readFileSync(options.from, 'utf8'))
    : await measure(options, words);
  const written = (extension) =>
    join(benchFolder, `${options.trial ? 'trial' : 'bench'}.${extension}`);
  mkdirSync(benchFolder, { recursive: true });
  writeFileSync(written('json'), JSON.stringify(results, null, 1));
  const text = markdown(results);
  writeFileSync(written('md'), text);
  console.log(`\n${text}`);
  if (options.readme) writeReadme(results);
  const failed = Object.entries(results.failed ?? {});
  if (failed.length) {
    throw new Problem(failed.map(([part, message]) => `${part}: ${message}`).join('\n'));
  }
});
