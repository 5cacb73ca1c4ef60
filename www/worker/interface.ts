/**
 * What the page may call in the worker, by name. The page calls through types that are made of these
 * functions (`solver/remote.ts`), so that a question is one method of the engine and one use.
 */

import { exampleFile, type PanelStart, type Solver } from '../pkg/engine/shape_up.js';
import { missingFiles, open, type Opening } from './open.ts';
import { findRemedies } from './remedies.ts';
import { SLICE_MS, type Scheduler } from './scheduler.ts';
import { runInSlices, stopTrials } from './trials.ts';
import { mostFaces, warmUpWhenQuiet } from './warm-up.ts';
import type { Shown } from './frames.ts';
import type { FromWorker } from '../solver/events.ts';
import type { Drag, Edit, MapNorm, MapWeights, NamedBytes } from '../solver/types.ts';

/** Commands, which have no answer. Their errors are told as `trouble`. */
export const commandsOf = (scheduler: Scheduler) => ({
  /**
   * Iterates until converged.
   * @param ignoreCollapse goes on although the shape collapses, which otherwise ends a run outside a drag
   */
  run(ignoreCollapse?: boolean) {
    stopTrials();
    scheduler.run(ignoreCollapse);
  },
  pause: () => scheduler.pause(),
  drag(drag: Drag) {
    stopTrials();
    scheduler.drag(drag);
  },
  /** Sets what is sent with each frame besides positions. */
  show(shown: Shown) {
    scheduler.frames.shown = shown;
    scheduler.frames.due = scheduler.isLoaded;
    scheduler.sendFrame();
  },
  /** Returns a buffer of positions. */
  recycle(positions: Float64Array) {
    scheduler.frames.takeBack(positions);
    warmUpWhenQuiet(() => scheduler.isIterating);
    scheduler.sendFrame();
  },
});

/** Changes of the model or of the shape that is shown. */
export function changesOf(solver: Solver, scheduler: Scheduler) {
  /** @param action makes what is being tried useless */
  const changing = <T>(action: () => T) => {
    stopTrials();
    return action();
  };
  /** @param action performed after the run has ended */
  const paused = <T>(action: () => T) => {
    scheduler.pause();
    return action();
  };
  /** @param action changes the displayed shape only */
  const shows = <T>(action: () => T) => {
    const result = action();
    scheduler.frames.due = true;
    scheduler.sendFrame();
    return result;
  };
  return {
    /**
     * Opens the first scene, or else the first file; the others may be files that it names. If
     * refused, the current model stays.
     */
    open: (given: Opening) => changing(() => open(solver, scheduler, given)),
    /** Edits the document, as one step of undo. */
    edit(edit: Edit) {
      stopTrials();
      if (edit.type === 'reset') scheduler.pause();
      scheduler.betweenRuns(() => solver.edit(edit));
      return null;
    },
    /** Adds one kind of constraint to all panels, within the tolerance, and runs: one step of undo. */
    makePanels(kind: string, tolerance: number, from: PanelStart) {
      stopTrials();
      scheduler.runFor(() => solver.makePanels(kind, tolerance, from));
      return null;
    },
    /** Edits and runs, as one step of undo. */
    editAndRun(edit: Edit) {
      stopTrials();
      scheduler.runFor(() => solver.editAndRun(edit));
      return null;
    },
    /**
     * Applies the shape of the last trial, if it belongs to the current one.
     * @param joins as part of the last step of undo
     * @returns whether it was done
     */
    makeExact: (joins: boolean) =>
      paused(() => scheduler.betweenRuns(() => solver.accept(joins), true)),
    /** @returns the name of what was undone */
    undo: () => changing(() => paused(() => scheduler.betweenRuns(() => solver.undo() ?? null))),
    /** @returns the name of what was redone */
    redo: () => changing(() => paused(() => scheduler.betweenRuns(() => solver.redo() ?? null))),
    /** @returns whether it has converged */
    step: () => changing(() => paused(() => scheduler.step())),
    /** Performs the local step, or the global step after it. */
    halfStep: () => changing(() => paused(() => scheduler.halfStep())),
    /** Stores numbers of the build, which goals of a lesson may bound. */
    setBuildNumbers(ids: string[], values: Float64Array) {
      shows(() => solver.setBuildNumbers(ids, values));
      return null;
    },
    /**
     * Begins the search for variations of an exact shape.
     * @returns whether there can be any
     */
    findVariations: () => paused(() => shows(() => solver.findVariations())),
    /**
     * Shows the shape plus the variations times their coefficients.
     * @returns whether they belong to the current shape
     */
    showVariation: (coefficients: Float64Array) => shows(() => solver.showVariation(coefficients)),
    /**
     * Projects that back onto the constraints.
     * @returns the fraction reached; null if they belong to another shape
     */
    projectVariation: (coefficients: Float64Array) =>
      shows(() => solver.projectVariation(coefficients) ?? null),
    /**
     * Makes the projected shape the design, as one step of undo.
     * @returns whether there was anything to keep
     */
    keepVariation: () => scheduler.betweenRuns(() => solver.keepVariation(), false),
    leaveVariation: () => shows(() => solver.leaveVariation()),
  };
}

/**
 * Questions in which the worker has a part; the solver answers all others under its own names. They
 * leave document and shape as they are; some end a run, or the trial before.
 */
export const questionsOf = (
  solver: Solver,
  scheduler: Scheduler,
  post: (message: FromWorker) => void,
) => ({
  /**
   * Tries, alongside everything else, what meeting constraints exactly instead of within a distance
   * would cost; null if something changes meanwhile.
   */
  async exactOffer() {
    solver.tryExact();
    return (await runInSlices(solver, post)) ? solver.offer() : null;
  },
  /**
   * Searches for lower energy among equally exact shapes, until `endTrial` or a change; returns how
   * far it came, or null if that belongs to another shape.
   */
  async improvement() {
    solver.tryImprovement();
    await runInSlices(solver, post);
    return solver.offer();
  },
  endTrial() {
    stopTrials();
    return null;
  },
  /** Changes that lower the worst distance, tried on a copy; those found before something changes. */
  remedies: () => findRemedies(solver, post),
  /** Continues the search for variations for a slice. */
  advanceVariations: () => solver.advanceVariations(SLICE_MS),
  /** The number of faces up to which this computer stays interactive. */
  mostFaces,
  /** A flat map of the current shape; ends a run. */
  parametrize(weights: MapWeights, norm: MapNorm) {
    scheduler.pause();
    return solver.parametrize(weights, norm);
  },
  /** The settings of the map with the fewest flips, if fewer than `flipped`; ends a run. */
  fewerFlips(flipped: number) {
    scheduler.pause();
    return solver.fewerFlips(flipped);
  },
  /** The paths of files that a scene among these names and that are missing. */
  missingFiles: (files: NamedBytes[]) => missingFiles(solver, files),
  /** The bytes of an example's scene or mesh, by the name of the file. */
  exampleFile: (name: string) => exampleFile(name),
});

export type Commands = ReturnType<typeof commandsOf>;
export type Changes = ReturnType<typeof changesOf>;
type Own = ReturnType<typeof questionsOf>;

/** Methods by which the scheduler drives the solver, and those that change it. */
type Inner =
  | 'accept'
  | 'addFile'
  | 'advance'
  | 'beginRun'
  | 'endRun'
  | 'free'
  | 'ignoreCollapse'
  | 'keepUnwelded'
  | 'load'
  | 'remeshed'
  | 'restore'
  | 'restoreIteration'
  | 'setDefaultFrame'
  | 'singleStep'
  | 'tryExact'
  | 'tryImprovement'
  | 'writePositions';

/** All questions. */
export type Questions = Own & Omit<Solver, keyof Own | keyof Changes | keyof Commands | Inner>;
