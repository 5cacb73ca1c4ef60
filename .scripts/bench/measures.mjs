// Measures problems in a page with the solver module as shipped, which starts anew for each. Times
// are in milliseconds unless named otherwise. Those of a trial are short.

import init, { ModelCopy, Solver } from '/www/pkg/engine/shape_up.js';
import { spread, spreads, sum } from './statistics.mjs';

export { bytesPerMs, rates } from './limits.mjs';

const { memory } = await init();
const encoder = new TextEncoder();

/** Iterations of a run, and how many of the first ones are not counted. */
const STEPS = 25;
const UNCOUNTED = 5;
/** The least time of all iterations. */
const LEAST_MS = 1500;
/** How often an edit is made. */
const EDITS = 5;
/** Iterations between looks at the energy, and how little they change it in the end, relatively. */
const LOOK = 20;
const STILL = 1e-10;
/** Relative distance to the converged energy that counts as reached. */
const NEAR = 1e-4;
/** The longest that a run may take to come there, and the most runs that take no longer together. */
const LIMIT_MS = 3000;
const RUNS = 5;

/** Calls a function some times, with 0, 1, ...; returns the results. */
const times = (count, call) => Array.from({ length: count }, (_, k) => call(k));

/** Returns the milliseconds of a call. */
function timed(call) {
  const start = performance.now();
  call();
  return performance.now() - start;
}

/** Loads a problem with a setting of the solver; returns the milliseconds. */
function open(solver, { scene, mesh }, setting) {
  const document = JSON.parse(scene);
  Object.assign(document.solver, setting);
  const bytes = encoder.encode(JSON.stringify(document));
  const meshBytes = encoder.encode(mesh);
  return timed(() => {
    for (const path of solver.sceneFiles(bytes)) solver.addFile(path, meshBytes);
    solver.load('problem.shapeup.json', bytes);
  });
}

/** Times one iteration: the total, and the parts reported by the solver: shape, close, smooth, global. */
function step(solver) {
  const before = solver.report().seconds.parts;
  const total = timed(() => solver.step());
  const after = solver.report().seconds.parts;
  const own = Object.keys(after).map((name) => [name, 1e3 * (after[name] - before[name])]);
  return { total, ...Object.fromEntries(own) };
}

/** Milliseconds from changed constraints to the end of the first iteration. */
function changed(solver, k) {
  const edit = { setConstraint: { index: 0, weight: 1.5 + 0.5 * k } };
  return timed(() => (solver.edit(edit), solver.step()));
}

/** Milliseconds to add a handle, which is removed again. */
function handleAdded(solver, vertex) {
  const vertices = [vertex];
  const ms = timed(() => solver.edit({ addHandles: { vertices, fixed: false } }));
  solver.edit({ removeHandles: { vertices } });
  return ms;
}

/** The spread of iterations, of opening until the first one, and of edits. */
function iterationsWith(accelerator, problem, trial) {
  const solver = new Solver();
  const opening = () => open(solver, problem, { accelerator }) + step(solver).total;
  // The first opening compiles code and is not counted, nor is the first run.
  const opened = spread(times(4, opening).slice(1));
  const steps = [];
  for (let [round, spent] = [0, 0]; round < 4 || (spent < LEAST_MS && !trial); round++) {
    solver.edit('reset');
    const all = times(STEPS, () => step(solver));
    if (round > 0) steps.push(...all.slice(UNCOUNTED));
    spent += sum(all.map(({ total }) => total));
  }
  const { spare } = problem;
  const handle = spread(times(EDITS, (k) => handleAdded(solver, spare[k % spare.length])));
  const change = spread(times(EDITS, (k) => changed(solver, k)));
  solver.free();
  return { ...spreads(steps), opened, change, handle };
}

/** By accelerator: the default one last, when its code is compiled. */
export function iterations(problem, trial) {
  const of = (accelerator) => iterationsWith(accelerator, problem, trial);
  return { none: of('none'), 'quasi-newton': of('quasi-newton') };
}

/** Changed constraints with each numeric factor in turn. */
export function factors(problem, trial) {
  const rounds = trial ? 1 : Math.max(7, Math.min(41, Math.round(60_000 / problem.vertices)));
  const names = ['sprs-ldl', 'supernodal'];
  const solvers = names.map((factorization) => {
    const solver = new Solver();
    open(solver, problem, { factorization });
    return solver;
  });
  // The first round compiles code.
  const all = times(rounds + 1, (round) => solvers.map((solver) => changed(solver, round)));
  const counted = all.slice(1);
  return Object.fromEntries(names.map((name, i) => [name, spread(counted.map((ms) => ms[i]))]));
}

/** Iterates until a goal, for some time, or until hardly anything changes. */
function descent(problem, accelerator, limit, goal = 0) {
  const solver = new Solver();
  open(solver, problem, { accelerator });
  const energy = () => solver.report().energy.final.total;
  const all = [];
  let [last, now] = [Infinity, energy()];
  const isStill = () => last - now <= STILL * now;
  while (sum(all) < limit && now > goal && !isStill()) {
    all.push(...times(LOOK, () => timed(() => solver.step())));
    [last, now] = [now, energy()];
  }
  return { energy: now, isStill: isStill(), all, trace: solver.trace() };
}

/** By accelerator: the seconds and iterations until the energy is near the converged one. */
export function convergence(problem) {
  const { energy, isStill } = descent(problem, 'quasi-newton', 3 * LIMIT_MS);
  // Without a certain goal there is nothing to compare.
  if (!isStill) return {};
  const goal = (1 + NEAR) * energy;
  const of = (accelerator) => {
    const seconds = [];
    let iterations;
    do {
      const { all, trace } = descent(problem, accelerator, LIMIT_MS, goal);
      // Six numbers per iteration: first its number, last the total energy.
      const reached = trace.findIndex((value, k) => k % 6 === 5 && value <= goal);
      iterations = reached < 0 ? null : trace[reached - 5];
      seconds.push(sum(all.slice(0, iterations ?? all.length)) / 1e3);
    } while (seconds.length < RUNS && 1e3 * sum(seconds) < LIMIT_MS);
    return { iterations, seconds: spread(seconds) };
  };
  return Object.fromEntries(['none', 'quasi-newton', 'anderson'].map((name) => [name, of(name)]));
}

/** Hard constraints met from the soft solution, and the memory of the module. */
export function exact(problem) {
  const solver = new Solver();
  open(solver, problem);
  solver.beginRun();
  while (!solver.step());
  solver.endRun();
  const { seconds, max_distance, misses } = solver.report().exact;
  const distance = max_distance / problem.size;
  return { seconds, distance, misses, megabytes: memory.buffer.byteLength / 1e6 };
}

/** Panels along the lines of curvature of a mesh, in a module that has run nothing yet. */
export function remesh({ mesh, panels: count, boundary }) {
  const solver = new Solver();
  solver.load('problem.obj', encoder.encode(mesh));
  const copy = new ModelCopy(solver.scene(), solver.generation(), () => {});
  const settings = { count, follow: 0.67, even: 0.25, boundary };
  return { seconds: timed(() => copy.layOutPanels(settings, new Uint32Array(0))) / 1e3 };
}

/** Flat maps: the first one, in a module that has run nothing yet, and three more. */
export function maps(problem) {
  const solver = new Solver();
  solver.load('problem.obj', encoder.encode(problem.mesh));
  const copy = new ModelCopy(solver.scene(), solver.generation(), () => {});
  let eigenvalue;
  const once = () => timed(() => ({ eigenvalue } = copy.parametrize(problem.map, 'boundary')));
  const [cold, ...others] = times(4, once);
  return { cold, total: spread(others), eigenvalue };
}
