/**
 * What the page may call in the worker, by name. The page calls through types that are made of these
 * functions (`solver/remote.ts`), so that a question is one method of the engine and one use.
 */

import { exampleFile, type LaidOut, type PanelStart, type Solver } from '../pkg/engine/shape_up.js';
import { editNow, type RowKey } from '../solver/rows.ts';
import { missingFiles, open, type Opening } from './open.ts';
import type { Scheduler } from './scheduler.ts';
import { mostFaces, warmUpWhenQuiet } from './warm-up.ts';
import type { Shown } from './frames.ts';
import type { Edit, ExactReport, ExactShape } from '../pkg/engine/shape_up.js';
import type { Drag, NamedBytes, Snapshot } from '../solver/types.ts';

/** Commands, which have no answer. Their errors are told as `trouble`. */
export const commandsOf = (scheduler: Scheduler) => ({
  /** Iterates until converged. */
  run: () => scheduler.run(),
  pause: () => scheduler.pause(),
  drag: (drag: Drag) => scheduler.drag(drag),
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
  /** The edit for the lists as they are now; null if there is nothing left to do. */
  const now = (edit: Edit, row?: RowKey) =>
    row !== undefined && scheduler.document ? editNow(edit, row, scheduler.document) : edit;
  const shown = (): Snapshot => ({ text: solver.scene(), generation: solver.generation() });
  return {
    /**
     * Opens the first scene, or else the first file; the others may be files that it names. If it is
     * refused, or has more than `most` faces, whose number is returned, the current model stays.
     */
    open: (given: Opening) => open(solver, scheduler, given),
    /**
     * Edits the document, as one step of undo.
     * @param row the row that it names
     */
    edit(asked: Edit, row?: RowKey) {
      const edit = now(asked, row);
      if (edit === null) return null;
      if (edit === 'reset') scheduler.pause();
      // By the tolerance a run is judged, and goes on.
      if (typeof edit === 'object' && 'setTolerance' in edit) {
        solver.edit(edit);
        scheduler.changed();
      } else scheduler.betweenRuns(() => solver.edit(edit));
      return null;
    },
    /** Adds one kind of constraint to all panels, within the tolerance, and runs: one step of undo. */
    makePanels(kind: string, tolerance: number, from: PanelStart) {
      scheduler.runFor(() => solver.makePanels(kind, tolerance, from));
      return null;
    },
    /** Edits and runs, as one step of undo; with the parameters of `edit`. */
    editAndRun(asked: Edit, row?: RowKey) {
      const edit = now(asked, row);
      if (edit !== null) scheduler.runFor(() => solver.editAndRun(edit));
      return null;
    },
    /**
     * Applies a shape that the second worker has made exact, if it belongs to the current one.
     * @param positions `#V by 3`
     * @param unasked as part of the last step of undo, and with the requirements as they are
     * @returns whether it was done
     */
    makeExact: (shape: ExactShape, positions: Float64Array, unasked: boolean) =>
      !scheduler.isMoving &&
      scheduler.betweenRuns(() => solver.makeExact(shape, positions, unasked), true),
    /**
     * Puts panels that the second worker has laid out in place of the mesh, if they are for the current
     * model, as one step of undo.
     * @returns whether it was done
     */
    takePanels(generation: number, { positions, offsets, indices }: LaidOut) {
      scheduler.pause();
      return scheduler.betweenRuns(() =>
        solver.takePanels(generation, positions, offsets, indices),
      );
    },
    /** @returns the name of what was undone */
    undo: () => paused(() => scheduler.betweenRuns(() => solver.undo() ?? null)),
    /** @returns the name of what was redone */
    redo: () => paused(() => scheduler.betweenRuns(() => solver.redo() ?? null)),
    /** @returns the new numbers */
    step: () => paused(() => scheduler.step()),
    /** Performs the local step, or the global step after it. */
    halfStep: () => paused(() => scheduler.halfStep()),
    /**
     * Stores numbers of the build, which goals of a lesson may bound, if its shape is still the current one.
     * @param positions `#V by 3`
     */
    setBuildNumbers(positions: Float64Array, ids: string[], values: Float64Array) {
      shows(() => solver.setBuildNumbers(positions, ids, values));
      return null;
    },
    /**
     * Shows a variation of the shape with this generation.
     * @param positions `#V by 3`
     * @param report if they were projected back onto the constraints
     * @returns whether it is the current shape that is varied
     */
    showVariation: (generation: number, positions: Float64Array, report: ExactReport | null) =>
      !scheduler.isMoving && shows(() => solver.showVariation(generation, positions, report)),
    /**
     * Makes the projected shape the design, as one step of undo.
     * @returns whether there was anything to keep
     */
    keepVariation: () => scheduler.betweenRuns(() => solver.keepVariation(), false),
    /** Shows the shape before a variation that is not kept. */
    leaveVariation() {
      const before = solver.generation();
      shows(() => solver.leaveVariation());
      // A scene that an edit has sent while it was shown, as that of the tolerance, has its shape.
      if (solver.generation() !== before) scheduler.sendScene();
    },
    /** Ends a run; returns what is shown, for the second worker. */
    rest: () => paused(shown),
    /** Returns what is shown; null during a run or a drag, which goes on. */
    atRest: () => (scheduler.isMoving ? null : shown()),
  };
}

const indexOf = (row: number, { document }: Scheduler) =>
  document?.constraints.findIndex(({ number }) => number === row) ?? -1;

/**
 * Questions in which the worker has a part; the solver answers all others under its own names. They
 * leave document and shape as they are.
 */
export const questionsOf = (solver: Solver, scheduler: Scheduler) => ({
  /** What the constraint with this number acts on; null if it is gone. */
  members(row: number) {
    const index = indexOf(row, scheduler);
    return index < 0 ? null : solver.members(index);
  },
  /** The worst elements of the constraint with this number; none if it is gone. */
  worstConstraints(row: number, ...given: [count: number, tolerance?: number]) {
    const index = indexOf(row, scheduler);
    return index < 0 ? [] : solver.worstConstraints(index, ...given);
  },
  /** The number of faces up to which this computer stays interactive. */
  mostFaces,
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
  | 'addFile'
  | 'beginRun'
  | 'endRun'
  | 'free'
  | 'load'
  | 'openRead'
  | 'read'
  | 'remeshed'
  | 'restore'
  | 'restoreIteration'
  | 'singleStep'
  | 'writePositions';

/** All questions. */
export type Questions = Own & Omit<Solver, keyof Own | keyof Changes | keyof Commands | Inner>;
