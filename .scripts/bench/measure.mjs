// Measurements of the problems, in the order of the options; without tables.

import { outputOf, say } from '../run.mjs';
import { accelerators, problemOf, problems } from './problems.mjs';
import { median, medians, reached, spread } from './statistics.mjs';

/** Relative distances to the converged energy. */
export const nearness = [1e-2, 1e-4, 1e-6];

/** Iterations of a run, and how many of the first ones are not counted. */
const STEPS = [25, 5];
/** Approximate total duration of the runs. */
const RUNS_MS = 1500;
/** Approximate milliseconds per iteration and vertex. */
const MS_PER_VERTEX = 2.5e-4;
/** The site's own worker: milliseconds before the measurement, and of the measurement. */
const RUN_MS = { usual: { settle: 1000, during: 2500 }, trial: { settle: 50, during: 100 } };
/** Largest number of nonzeros for which the plain iteration has a factor in double precision. */
const MOST_DOUBLE = 2 ** 19;
/** A goal that no energy reaches. */
const NO_GOAL = -1;
/** Number of iterations without change after which a run has converged. */
const PATIENCE = 5;

const keys = ['total', 'shape', 'close', 'smooth', 'global'];
const byPart = (steps) =>
  Object.fromEntries(keys.map((key) => [key, spread(steps.map((step) => step[key]))]));

/** Measures opening, iterating and editing of one problem in one place. */
async function measureOne(place, problem, { vertices, accelerator }) {
  const isDefault = accelerator === 'quasi-newton';
  const estimate = STEPS[0] * vertices * MS_PER_VERTEX;
  const large = vertices > 50_000;
  const result = await place.perform({
    measure: 'iterations',
    problem,
    loads: large ? 3 : 4,
    rounds: 1 + Math.max(3, Math.min(12, Math.round(RUNS_MS / estimate))),
    steps: STEPS,
    edits: isDefault ? (large ? 4 : 7) : 0,
  });
  const { report, cold, openings, steps, fresh, handle, change, drag, bytes } = result;
  const nonzeros = report.factor_nonzeros;
  const bytesOfNumber = isDefault || nonzeros > MOST_DOUBLE ? 4 : 8;
  const limit = await place.stream(nonzeros * bytesOfNumber);
  return {
    nonzeros,
    unknowns: report.unknowns,
    constraints: Object.values(report.constraints).reduce((sum, count) => sum + count, 0),
    setUp: medians(openings),
    cold: cold ?? null,
    step: byPart(steps),
    fresh: byPart(fresh),
    handle: median(handle),
    change: median(change),
    drag: byPart(drag),
    bytes: bytes ?? null,
    bytesOfNumber,
    /** Milliseconds to read the factor's nonzeros twice. */
    limit: limit === null ? null : 2 * limit,
  };
}

/** Returns one row per problem, size, place and accelerator. */
export async function measureIterations({ sizes, letters, places, trial }) {
  const rows = [];
  for (const size of sizes) {
    for (const letter of letters.filter((letter) => !problems[letter].maps)) {
      for (const accelerator of ['none', 'quasi-newton']) {
        for (const [where, place] of Object.entries(places)) {
          const problem = problemOf(letter, size, { accelerator });
          const { vertices } = problem;
          say(`${letter}, ${vertices} vertices, ${accelerator}, ${where}`);
          const row = await measureOne(place, problem, { vertices, accelerator });
          const runs = place.run && accelerator === 'quasi-newton';
          const run = runs ? await place.run(problem, trial ? RUN_MS.trial : RUN_MS.usual) : null;
          rows.push({ problem: letter, vertices, where, accelerator, ...row, run });
        }
      }
    }
  }
  return rows;
}

/** Sizes around which the faster numeric factor changes. */
const FACTOR_SIZES = [500, 1000, 2500, 5000, 10_000];
const factorizations = ['sprs-ldl', 'supernodal'];

/** Measures changing constraints with both numeric factors, in the browser, by problem and size. */
export async function measureFactors(browser, trial) {
  const rows = [];
  for (const size of trial ? [400] : FACTOR_SIZES) {
    for (const letter of ['A', 'B', 'C']) {
      const problem = problemOf(letter, size);
      const { vertices } = problem;
      say(`${letter}, ${vertices} vertices, both numeric factors`);
      const rounds = trial ? 1 : Math.max(7, Math.min(41, Math.round(60_000 / size)));
      const task = { measure: 'factors', problem, factorizations, rounds };
      const { runs, unknowns, nonzeros } = await browser.perform(task);
      const of = Object.fromEntries(
        runs.map(({ factorization, ...times }) => {
          const spreads = Object.entries(times).map(([key, list]) => [key, spread(list)]);
          return [factorization, Object.fromEntries(spreads)];
        }),
      );
      rows.push({ problem: letter, vertices, unknowns, nonzeros, of });
    }
  }
  return rows;
}

/** Measures the time to the converged energy, by accelerator. `native` computes that energy. */
export async function measureConvergence({ sizes, letters, places, native, limitMs }) {
  const rows = [];
  for (const size of sizes) {
    for (const letter of letters.filter((letter) => problems[letter].converges)) {
      say(`${letter}, ${size} vertices: the converged energy`);
      const found = await native.perform({
        measure: 'convergence',
        problem: problemOf(letter, size),
        goal: NO_GOAL,
        limit: 3 * limitMs,
        patience: PATIENCE,
      });
      const ended = found.steps.reduce((sum, ms) => sum + ms, 0) < 3 * limitMs;
      let converged = Math.min(...found.energies);
      const runs = [];
      for (const accelerator of accelerators) {
        for (const [where, place] of Object.entries(places)) {
          const problem = problemOf(letter, size, { accelerator });
          say(`${letter}, ${problem.vertices} vertices, ${accelerator}, ${where}: until converged`);
          const run = await place.perform({
            measure: 'convergence',
            problem,
            goal: converged * (1 + nearness.at(-1)),
            limit: limitMs,
            patience: 0,
          });
          const { vertices } = problem;
          runs.push({ key: { problem: letter, vertices, where, accelerator }, run });
          converged = Math.min(converged, ...run.energies);
        }
      }
      for (const { key, run } of runs) {
        const spent = run.steps.reduce((sum, ms) => sum + ms, 0);
        rows.push({
          ...key,
          converged,
          /** Whether more iterations would not have lowered the energy. */
          certain: ended,
          start: run.energies[0],
          least: Math.min(...run.energies),
          iterations: run.steps.length,
          ms: spent,
          reached: reached(run, converged, nearness),
        });
      }
    }
  }
  return rows;
}

/** Maps have as many vertices as the paper's, 35,000, in place of 30,000. */
export const mapSizes = (sizes) => sizes.map((size) => (size === 30_000 ? 35_000 : size));

/** Measures conformal maps; in the browser also the first one of a module. */
export async function measureMaps({ sizes, letters, places }) {
  const rows = [];
  for (const size of sizes) {
    for (const letter of letters.filter((letter) => problems[letter].maps)) {
      for (const [where, place] of Object.entries(places)) {
        const problem = problemOf(letter, size);
        const { vertices } = problem;
        say(`${letter}, ${vertices} vertices, ${where}`);
        const weights = problems[letter].maps;
        const task = { measure: 'map', problem, weights, rounds: 3 };
        const { runs, ...map } = await place.perform(task);
        rows.push({ problem: letter, where, ...map, ...medians(runs), vertices });
      }
    }
  }
  return rows;
}

/** Returns the wasm memory in bytes after each of ten models of problem A, opened in turn. */
export async function measureModels(browser, size) {
  const seeds = Array.from({ length: 10 }, (_, k) => k + 1);
  const ten = seeds.map((seed) => problemOf('A', size, { seed }));
  say(`ten models of ${ten[0].vertices} vertices in turn`);
  const bytes = await browser.perform({ measure: 'models', problems: ten });
  return { vertices: ten[0].vertices, ...bytes };
}

/** Returns the tables of every single operator. */
export async function measureOperators({ browser, native }) {
  const tables = {};
  if (native) {
    say('every operator alone, natively');
    tables.native = outputOf('cargo', ['bench', '--locked', '--quiet', '--bench', 'operators']);
  }
  if (browser) {
    say('every operator alone, in the browser');
    tables.browser = await browser.operators();
  }
  return tables;
}
