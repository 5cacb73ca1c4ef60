// Measures problems with the solver module as shipped, which starts anew for each. Times are in
// milliseconds unless named otherwise.

import init, { ModelCopy, Solver } from '/module/shape_up.js';
import { iterationsUntil, median, medians } from './statistics.mjs';

const { memory } = await init();
const encoder = new TextEncoder();

/** Iterations of a run, and how many of the first ones are not counted. */
const STEPS = 25;
const UNCOUNTED = 5;
/** Iterations between looks at the energy, and how little they change it in the end, relatively. */
const LOOK = 20;
const STILL = 1e-10;
/** Relative distance to the converged energy that counts as reached. */
const NEAR = 1e-4;

/** Returns the result of a call, and its milliseconds. */
function timed(call) {
  const start = performance.now();
  const value = call();
  return [value, performance.now() - start];
}

/** Loads a problem, with other settings of the solver if given. */
function open(solver, { scene, mesh }, settings = {}) {
  const document = JSON.parse(scene);
  Object.assign(document.solver, settings);
  const bytes = encoder.encode(JSON.stringify(document));
  const meshBytes = encoder.encode(mesh);
  return timed(() => {
    for (const path of solver.sceneFiles(bytes)) solver.addFile(path, meshBytes);
    solver.load('problem.shapeup.json', bytes);
  })[1];
}

function run(solver) {
  solver.beginRun();
  while (!solver.step());
  solver.endRun();
}

/** Times one iteration: the total, and the parts reported by the solver. */
function step(solver) {
  const before = solver.iterateSeconds();
  const [, total] = timed(() => solver.step());
  const after = solver.iterateSeconds();
  const [shape, close, , global] = after.map((seconds, i) => 1e3 * (seconds - before[i]));
  return { total, shape, close, global };
}

/**
 * Medians of the iterations of some runs, which take `least` milliseconds or more, and with `edits`
 * of opening and editing until the first iteration.
 */
export function iterations({ problem, least, edits }) {
  const solver = new Solver();
  const opening = () => open(solver, problem) + step(solver).total;
  // The first opening compiles code and is not counted.
  opening();
  const opened = median(Array.from({ length: edits && 3 }, opening));
  const steps = [];
  for (let [round, spent] = [0, 0]; round < 4 || spent < least; round++) {
    solver.edit('reset');
    const all = Array.from({ length: STEPS }, () => step(solver));
    // The first run compiles code, too.
    if (round > 0) steps.push(...all.slice(UNCOUNTED));
    spent += all.reduce((sum, { total }) => sum + total, 0);
  }
  const handle = [];
  const change = [];
  for (let k = 0; k < edits; k++) {
    const vertices = [problem.spare[k % problem.spare.length]];
    handle.push(timed(() => solver.edit({ addHandles: { vertices, fixed: false } }))[1]);
    solver.edit({ removeHandles: { vertices } });
  }
  for (let k = 0; k < edits; k++) change.push(changed(solver, k));
  return { ...medians(steps), opened, change: median(change), handle: median(handle) };
}

/** Milliseconds from changed constraints to the end of the first iteration. */
function changed(solver, k) {
  const edit = { setConstraint: { index: 0, weight: 1.5 + 0.5 * k } };
  return timed(() => (solver.edit(edit), solver.step()))[1];
}

/** Changed constraints with each numeric factor in turn. */
export function factors({ problem, rounds }) {
  const taken = ['sprs-ldl', 'supernodal'].map((factorization) => {
    const solver = new Solver();
    open(solver, problem, { factorization });
    return { factorization, solver, times: [] };
  });
  for (let round = 0; round <= rounds; round++) {
    for (const { solver, times } of taken) {
      const ms = changed(solver, round);
      if (round > 0) times.push(ms);
    }
  }
  return Object.fromEntries(
    taken.map(({ factorization, times }) => [factorization, median(times)]),
  );
}

/** Energies and milliseconds of iterations until a goal, a time, or until hardly anything changes. */
function descent(problem, accelerator, goal, limit) {
  const solver = new Solver();
  open(solver, problem, { accelerator });
  const energy = () => solver.report().energy.final.total;
  const energies = [energy()];
  const times = [];
  let [spent, last, still] = [0, Infinity, false];
  while (spent < limit && energies.at(-1) > goal && !still) {
    for (let k = 0; k < LOOK && spent < limit; k++) {
      times.push(timed(() => solver.step())[1]);
      spent += times.at(-1);
    }
    // Six numbers per iteration: first its number, last the total. Long traces have only every
    // second, fourth, ... iteration.
    const trace = solver.trace();
    for (let k = 0; k < trace.length; k += 6)
      while (energies.length <= trace[k]) energies.push(trace[k + 5]);
    const now = energy();
    still = last - now <= STILL * now;
    last = now;
  }
  return { energies, times, spent, still };
}

/** By accelerator: the seconds and iterations until the energy is near the converged one. */
export function convergence({ problem, limit }) {
  const { energies, still } = descent(problem, 'quasi-newton', -1, 3 * limit);
  // Without a certain goal there is nothing to compare.
  if (!still) return {};
  const goal = (1 + NEAR) * Math.min(...energies);
  const of = (accelerator) => {
    const { energies, times, spent } = descent(problem, accelerator, goal, limit);
    const iterations = iterationsUntil(goal, energies);
    const ms = times.slice(0, iterations ?? 0).reduce((sum, one) => sum + one, 0);
    return { iterations, seconds: (iterations === null ? spent : ms) / 1e3 };
  };
  return Object.fromEntries(['none', 'quasi-newton', 'anderson'].map((name) => [name, of(name)]));
}

/** Hard constraints met from the soft solution, and the memory of the module. */
export function exact({ problem }) {
  const solver = new Solver();
  open(solver, problem);
  run(solver);
  const { seconds, max_distance, misses } = solver.report().exact;
  const distance = max_distance / problem.size;
  return { seconds, distance, misses, megabytes: memory.buffer.byteLength / 1e6 };
}

/** Flat maps: the first one, in a module that has run nothing yet, and three more. */
export function map({ problem }) {
  const solver = new Solver();
  solver.load('problem.obj', encoder.encode(problem.mesh));
  const copy = new ModelCopy(solver.scene(), solver.generation());
  const once = () => timed(() => copy.parametrize(problem.map, 'boundary'));
  const [[{ eigenvalue }, cold], ...others] = [once(), once(), once(), once()];
  return { cold, total: median(others.map(([, ms]) => ms)), eigenvalue };
}

/** A mesh as opened, whose panels are made of a kind: lengths relative to the mean edge. */
export function folds({ problem: { name, text, kind, way } }) {
  const solver = new Solver();
  const { tolerance, meanEdge } = solver.load(name, encoder.encode(text));
  const [, ms] = timed(() => {
    if (way === 'press') {
      solver.makePanels(kind, tolerance, 'now');
    } else {
      const require = way === 'exact' ? way : { within: tolerance };
      solver.edit({ addConstraint: { kind, params: {}, on: 'faces', weight: 1 } });
      solver.edit({ setConstraint: { index: 0, require } });
    }
    run(solver);
  });
  const { exact, folded, moved, energy } = solver.report();
  return {
    ...{ folded: folded ?? 0, met: exact.met ? 'yes' : 'no', eased: exact.eased?.panels ?? 0 },
    ...{ tolerance: exact.tolerance / meanEdge, farthest: exact.max_distance / meanEdge },
    ...{ moved: moved.max / meanEdge, mean: moved.mean / meanEdge, attempts: exact.attempts },
    energy: (energy.final.close + energy.final.smooth) / meanEdge ** 2,
    seconds: ms / 1e3,
  };
}
