/** Handlers of the page's messages: one entry per command and per request. */

import { exampleFile, type Solver } from '../pkg/engine/shape_up.js';
import { missingFiles, open } from './open.ts';
import { findRemedies } from './remedies.ts';
import { runInSlices, stopTrials } from './trials.ts';
import { mostFaces, warmUpWhenQuiet } from './warm-up.ts';
import type { Scheduler } from './scheduler.ts';
import type { CommandHandlers, FromWorker, RequestHandlers } from '../solver/messages.ts';

export const commandHandlers = (scheduler: Scheduler): Omit<CommandHandlers, 'ping'> => ({
  recycle({ positions }) {
    scheduler.frames.takeBack(positions);
    warmUpWhenQuiet(() => scheduler.isIterating);
    scheduler.sendFrame();
  },
  show(shown) {
    scheduler.frames.shown = shown;
    scheduler.frames.due = scheduler.isLoaded;
    scheduler.sendFrame();
  },
  run: ({ ignoreCollapse }) => scheduler.run(ignoreCollapse),
  pause: () => scheduler.pause(),
  drag: (message) => scheduler.drag(message),
});

export function requestHandlers(
  solver: Solver,
  scheduler: Scheduler,
  post: (message: FromWorker, transfer?: Transferable[]) => void,
): RequestHandlers {
  /** @param action performed after the run has ended */
  const paused = <T>(action: () => T) => {
    scheduler.pause();
    return action();
  };
  return {
    open: (message) => open(solver, scheduler, message),
    edit({ edit }) {
      if (edit.type === 'reset') scheduler.pause();
      scheduler.betweenRuns(() => solver.edit(edit));
      return null;
    },
    makePanels({ kind, tolerance, from }) {
      scheduler.runFor(() => solver.makePanels(kind, tolerance, from));
      return null;
    },
    editAndRun({ edit }) {
      scheduler.runFor(() => solver.editAndRun(edit));
      return null;
    },
    async exactOffer() {
      solver.tryExact();
      return (await runInSlices(solver, post)) ? solver.offer() : null;
    },
    async improvement() {
      solver.tryImprovement();
      await runInSlices(solver, post);
      return solver.offer();
    },
    endTrial() {
      stopTrials();
      return null;
    },
    makeExact: ({ joins }) => paused(() => scheduler.betweenRuns(() => solver.accept(joins), true)),
    variations: ({ ask }) =>
      import('./variations.ts').then((it) => it.answer(solver, scheduler, ask)),
    undo: () => paused(() => scheduler.betweenRuns(() => solver.undo() ?? null)),
    redo: () => paused(() => scheduler.betweenRuns(() => solver.redo() ?? null)),
    step: () => paused(() => scheduler.step()),
    halfStep: () => paused(() => scheduler.halfStep()),
    originalValues: ({ measure }) => solver.originalValues(measure),
    originalPositions: () => solver.originalPositions(),
    angles: () => solver.angles(),
    members: ({ constraint }) => solver.members(constraint),
    rowColours: () => solver.rowColours(),
    previews: ({ places }) => solver.previews(places),
    worst: ({ measure, row, count }) =>
      measure ? solver.worstFaces(measure, count) : solver.worstConstraints(row ?? 0, count),
    flawed: ({ flaw }) => solver.flawed(flaw),
    verdict: ({ tolerance }) => solver.verdict(tolerance),
    forecast: () => solver.forecast(),
    remedies: () => findRemedies(solver, post),
    mostFaces,
    buildNumbers: () => solver.buildNumbers(),
    setBuildNumbers({ ids, values }) {
      solver.setBuildNumbers(ids, values);
      scheduler.frames.due = true;
      scheduler.sendFrame();
      return null;
    },
    results: ({ student, time }) => solver.results(student, time),
    select: ({ request }) => solver.select(request),
    scene: () => solver.scene(),
    obj({ uv, unwelded }) {
      if (unwelded) return solver.objUnwelded();
      return uv ? solver.objWithUv(uv) : solver.obj();
    },
    parametrize: ({ weights, norm }) => paused(() => solver.parametrize(weights, norm)),
    missingFiles: ({ files }) => missingFiles(solver, files),
    fewerFlips: ({ flipped }) => paused(() => solver.fewerFlips(flipped)),
    table: ({ table }) => solver.table(table),
    trace: () => solver.trace(),
    exampleFile: ({ name }) => exampleFile(name),
    meshOperations: () => solver.meshOperations(),
    remeshing: ({ asked }) => solver.remeshing(asked),
    refinements: ({ scheme, keep }) => solver.refinements(scheme, keep),
  };
}
