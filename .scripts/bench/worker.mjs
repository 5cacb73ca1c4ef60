// Times of one problem in the browser, under the same names as in tests/bench/problems.rs, which
// measures natively. Runs in its own worker with the solver module as shipped. Times are in ms.

import init, { Solver } from '/solver/shape_up.js';

const { memory } = await init();
const encoder = new TextEncoder();

/** Returns the result of a call, and its milliseconds. */
function timed(call) {
  const start = performance.now();
  const value = call();
  return [value, performance.now() - start];
}

function open(solver, { sceneBytes, meshBytes }) {
  for (const path of solver.sceneFiles(sceneBytes)) solver.addFile(path, meshBytes);
  solver.load('problem.shapeup.json', sceneBytes);
}

/** Moves the handles by a fraction of their displacement. */
function drag(solver, { vertices, from, to }, part) {
  if (vertices.length === 0) return;
  const targets = from.map((x, i) => x + part * (to[i] - x));
  solver.drag(vertices, targets, 'start');
  solver.drag(vertices, targets, 'end');
}

/** Times one iteration: the total, and the parts reported by the solver. */
function step(solver) {
  const before = solver.iterateSeconds();
  const [, total] = timed(() => solver.step());
  const after = solver.iterateSeconds();
  const [shape, close, smooth, global] = after.map((seconds, i) => 1e3 * (seconds - before[i]));
  return { total, shape, close, smooth, global };
}

function opening(solver, problem) {
  const [, total] = timed(() => open(solver, problem));
  const { assemble, order, factor } = solver.report().seconds;
  const first = total + step(solver).total;
  return { total, assemble: 1e3 * assemble, order: 1e3 * order, factor: 1e3 * factor, first };
}

function iterations({ problem, loads, rounds, steps: [all, unmeasured], edits }) {
  const solver = new Solver();
  const cold = opening(solver, problem);
  const bytes = { opened: memory.buffer.byteLength };
  const openings = [];
  for (let k = 1; k < loads; k++) openings.push(opening(solver, problem));
  bytes.again = memory.buffer.byteLength;

  const steps = [];
  const fresh = [];
  let report = null;
  drag(solver, problem.move, 1);
  for (let round = 0; round < rounds; round++) {
    solver.edit({ type: 'reset' });
    for (let k = 0; k < all; k++) {
      const one = step(solver);
      if (round > 0 && k === 0) fresh.push(one);
      else if (round > 0 && k >= unmeasured) steps.push(one);
    }
    report = solver.report();
  }

  const handle = [];
  const change = [];
  const dragged = [];
  for (let k = 0; k < edits; k++) {
    const vertices = [problem.spare[k % problem.spare.length]];
    handle.push(timed(() => solver.edit({ type: 'addHandles', vertices, fixed: false }))[1]);
    solver.edit({ type: 'removeHandles', vertices });
  }
  for (let k = 0; k < edits; k++) {
    const edit = { type: 'setConstraint', index: 0, weight: 1.5 + 0.5 * k };
    const edited = timed(() => solver.edit(edit))[1];
    change.push(edited + step(solver).total);
  }
  for (let k = 0; k < edits && problem.move.vertices.length > 0; k++) {
    const moved = timed(() => drag(solver, problem.move, 1 - 0.01 * k))[1];
    const one = step(solver);
    dragged.push({ ...one, total: one.total + moved });
  }
  return { report, cold, openings, steps, fresh, handle, change, drag: dragged, bytes };
}

/**
 * Milliseconds from changed constraints, and from a file, to the end of the first iteration, with
 * each numeric factor in turn. The scenes differ in the factor only.
 */
function factors({ problem, factorizations, rounds }) {
  const scene = JSON.parse(new TextDecoder().decode(problem.sceneBytes));
  const taken = factorizations.map((factorization) => {
    const solver = { ...scene.solver, factorization };
    const sceneBytes = encoder.encode(JSON.stringify({ ...scene, solver }));
    const one = { factorization, solver: new Solver(), change: [], factor: [], opened: [] };
    return { ...one, problem: { ...problem, sceneBytes } };
  });
  for (let round = 0; round <= rounds; round++) {
    for (const one of taken) {
      const [, opened] = timed(() => (open(one.solver, one.problem), one.solver.step()));
      if (round > 0) one.opened.push(opened);
      const edit = { type: 'setConstraint', index: 0, weight: 1.5 + 0.5 * round };
      const [, ms] = timed(() => (one.solver.edit(edit), one.solver.step()));
      if (round > 0) one.change.push(ms);
      if (round > 0) one.factor.push(1e3 * one.solver.report().seconds.factor);
    }
  }
  const { unknowns, factor_nonzeros: nonzeros } = taken[0].solver.report();
  const runs = taken.map(({ factorization, change, factor, opened }) => ({
    ...{ factorization, change, factor, opened },
  }));
  return { unknowns, nonzeros, runs };
}

/** Returns energy and milliseconds of every iteration, until the goal or the time limit. */
function convergence({ problem, goal, limit }) {
  const solver = new Solver();
  open(solver, problem);
  drag(solver, problem.move, 1);
  const energies = [solver.report().energy.final.total];
  const steps = [];
  // Six numbers per iteration: first its number, last the total. Long traces are subsampled to
  // every second, fourth, ... iteration. Requesting one costs more than an iteration.
  const takeTrace = () => {
    const trace = solver.trace();
    for (let k = 0; k < trace.length; k += 6)
      while (energies.length <= trace[k]) energies.push(trace[k + 5]);
  };
  let spent = 0;
  while (spent < limit && energies.at(-1) > goal) {
    for (let k = 0; k < 20 && spent < limit; k++) {
      const [, milliseconds] = timed(() => solver.step());
      steps.push(milliseconds);
      spent += milliseconds;
    }
    takeTrace();
  }
  return { energies, steps };
}

/**
 * Hard constraints met from the soft solution: milliseconds of both together, the solver's report
 * on them, and the times of variations if requested.
 */
function exact({ problem, step }) {
  const solver = new Solver();
  open(solver, problem);
  const [, total] = timed(() => {
    solver.beginRun();
    while (!solver.step());
    solver.endRun();
  });
  const bytes = memory.buffer.byteLength;
  return { total, exact: solver.report().exact, bytes, varied: step && variations(solver, step) };
}

/** Milliseconds to compute the modes, and for a step along each of them. */
function variations(solver, step) {
  const [found, modes] = timed(() => {
    if (!solver.findVariations()) return 0;
    for (;;) {
      const { found } = solver.advanceVariations(8);
      if (found !== null && found !== undefined) return found;
    }
  });
  const project = (k) => {
    const coefficients = new Float64Array(found);
    coefficients[k] = step;
    const [part, ms] = timed(() => solver.projectVariation(coefficients));
    return { part, ms, distance: solver.report().exact.max_distance };
  };
  return { modes, steps: Array.from({ length: found }, (_, k) => project(k)) };
}

/** Bytes of memory initially, and after opening each of some models in turn. */
function models({ problems }) {
  const solver = new Solver();
  const empty = memory.buffer.byteLength;
  const opened = problems.map((problem) => {
    open(solver, problem);
    solver.step();
    return memory.buffer.byteLength;
  });
  return { empty, opened };
}

/** Flat maps of one mesh: the first one, in a module that has run nothing yet, and some more. */
function map({ problem, weights, rounds }) {
  const solver = new Solver();
  solver.load('problem.obj', problem.meshBytes);
  const one = () => {
    const [{ eigenvalue, secondsOf }, total] = timed(() => solver.parametrize(weights, 'boundary'));
    const parts = Object.entries(secondsOf).map(([part, seconds]) => [part, 1e3 * seconds]);
    return { eigenvalue, run: { total, ...Object.fromEntries(parts) } };
  };
  const { eigenvalue, run } = one();
  const runs = Array.from({ length: rounds }, () => one().run);
  return { eigenvalue, cold: run.total, runs, bytes: memory.buffer.byteLength };
}

async function stream({ bytes }) {
  const module = await import('/bench/bench_browser.js');
  await module.default();
  return bytes.map((count) => module.stream(count));
}

const measures = { iterations, factors, convergence, exact, models, map, stream };

/** Fetches the files of a task, which is sent with their addresses only. */
async function fetched({ scene, mesh, move, from, spare }) {
  const text = await (await fetch(mesh)).text();
  return {
    sceneBytes: encoder.encode(scene),
    meshBytes: encoder.encode(text),
    move: {
      vertices: Uint32Array.from(move, ([vertex]) => vertex),
      from: Float64Array.from(from.flat()),
      to: Float64Array.from(move.flatMap(([, to]) => to)),
    },
    spare,
  };
}

onmessage = async ({ data: task }) => {
  try {
    if (task.problem) task.problem = await fetched(task.problem);
    if (task.problems) task.problems = await Promise.all(task.problems.map(fetched));
    postMessage({ result: await measures[task.measure](task) });
  } catch (thrown) {
    postMessage({ error: String(thrown?.stack ?? thrown) });
  }
};
postMessage({ ready: true });
