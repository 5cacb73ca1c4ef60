/** The handles as the page shows them, whether they can be dragged, and a drag of them. */

import { isLocked } from './panels-card.ts';
import type { Handle, SceneDocument } from '../solver/types.ts';
import type { State, Store } from './state.ts';
import type { SolverClient } from '../solver/solver-client.ts';

/** Why no drag begins where {@link areHandlesLocked}. */
export const HANDLES_LOCKED = 'Locked by the lesson: the handles stay as they are.';

/** Returns the handles, with the current targets of dragged ones. */
export function handlesNow({
  document,
  dragged,
  moved,
}: Pick<State, 'document' | 'dragged' | 'moved'>): Handle[] {
  const handles = document?.handles ?? [];
  if (!moved) return handles;
  const offsets = new Map(dragged.map((vertex, i) => [vertex, 3 * i]));
  return handles.map((handle) => {
    const at = offsets.get(handle.vertex);
    if (at === undefined) return handle;
    const [x, y, z] = moved.targets.subarray(at, at + 3);
    return { ...handle, target: [x, y, z] };
  });
}

/** Whether a lesson locks the handles. */
export const areHandlesLocked = (document: SceneDocument | null) =>
  isLocked({ document }, 'handles');

/** Names a handle that can be dragged, by its colour in the view; empty if there is none. */
export function draggableInWords(document: SceneDocument) {
  const { handles } = document;
  if (handles.length === 0 || areHandlesLocked(document)) return '';
  return handles.some(({ fixed }) => !fixed) ? 'a blue handle' : 'a handle';
}

const AXES = ['x', 'y', 'z'];

/**
 * Returns the displacement of the held handle for one of the pointer in pixels; undefined if none.
 */
export type MoveConstraint = (
  direction: string,
  dx: number,
  dy: number,
) => Float64Array | undefined;

export class HandleDrag {
  #store;
  #solver;
  #constrain;
  #vertices;
  /** Targets of the handles at the start, `#vertices by 3`. */
  #from;
  /** Current targets. */
  #targets: Float64Array;
  /** Displacement of the pointer since the start. */
  #by: [number, number] = [0, 0];
  /** The axis or plane of the gizmo being dragged. */
  #part;
  #plane = 'screen';
  /** The axis to which a key restricts the handle: 0, 1, 2 or none. */
  #axis: number | null = null;
  #isOver = false;
  #end;

  /**
   * @param vertex the handle under the pointer, or one of those at the gizmo
   * @param part of the gizmo
   * @param begun whether the solver has already begun a drag
   */
  constructor(
    store: Store,
    solver: SolverClient,
    constrain: MoveConstraint,
    vertex: number,
    part?: string,
    begun: boolean = false,
  ) {
    this.#store = store;
    this.#solver = solver;
    this.#constrain = constrain;
    this.#part = part;
    const { document, selection } = store.get();
    const together = (document?.handles ?? []).filter((handle) =>
      selection.vertices.has(vertex)
        ? selection.vertices.has(handle.vertex)
        : handle.vertex === vertex,
    );
    this.#vertices = Uint32Array.from(together, (handle) => handle.vertex);
    this.#from = Float64Array.from(together.flatMap((handle) => handle.target));
    this.#targets = this.#from;
    // A message about a finished run is outdated.
    store.set({ dragged: [...this.#vertices], gizmoPart: part, status: '' });
    // Refused, or an iteration of it failed, or another model is open: nothing may look moved.
    const ends = (['trouble', 'model'] as const).map((type) =>
      solver.on(type, () => this.cancel()),
    );
    this.#end = () => ends.forEach((end) => end());
    if (!begun) this.#send('start');
  }

  /**
   * @param dx pixels to the right since the beginning
   * @param dy pixels down
   * @param time of the event, on the clock of `performance.now()`
   */
  move(dx: number, dy: number, time: number = performance.now()) {
    if (this.#isOver) return;
    this.#by = [dx, dy];
    const direction = this.#axis !== null ? AXES[this.#axis] : (this.#part ?? this.#plane);
    const moved = this.#constrain(direction, dx, dy);
    // Near the horizon of the plane a pixel is arbitrarily far: the handle stays.
    if (!moved) return;
    this.#targets = this.#from.map((value, i) => value + moved[i % 3]);
    // The dots follow the pointer at once, the mesh when the solver answers.
    this.#store.set({ moved: { by: [...moved], targets: this.#targets }, gizmoPart: direction });
    this.#send('move', time);
  }

  /** Whether it has ended, by itself if it was refused or another model was opened. */
  get isOver() {
    return this.#isOver;
  }

  /** Sets the plane of the drag. */
  setPlane(plane: 'screen' | 'horizontal' | 'vertical') {
    this.#plane = plane;
  }

  /**
   * Toggles a restriction of the handles to an axis.
   * @param axis 0, 1, 2
   */
  toggleAxis(axis: number) {
    this.#axis = this.#axis === axis ? null : axis;
    this.move(...this.#by);
  }

  /** @returns whether anything has moved */
  end(): boolean {
    if (this.#isOver) return false;
    this.#send('end');
    const { document } = this.#store.get();
    // Valid until the solver sends the new document.
    if (document)
      this.#store.set({ document: { ...document, handles: handlesNow(this.#store.get()) } });
    this.#leave();
    return this.#targets.some((value, i) => value !== this.#from[i]);
  }

  /** Cancels the drag and restores the targets. */
  cancel() {
    if (this.#isOver) return;
    this.#targets = this.#from;
    this.#send('cancel');
    this.#leave();
  }

  #leave() {
    this.#isOver = true;
    this.#end();
    this.#store.set({ dragged: [], moved: null, gizmoPart: undefined });
  }

  #send(phase: 'start' | 'move' | 'end' | 'cancel', time?: number) {
    const vertices = this.#vertices.slice();
    const targets = this.#targets.slice();
    this.#solver.tell.drag({ vertices, targets, phase, time });
  }
}

/** Makes a vertex a handle, which may then be dragged, as one step of undo. */
export function makeHandle(store: Store, solver: SolverClient, vertex: number) {
  sendOfNew(solver, [vertex], 'make');
  store.set({ dragged: [vertex] });
}

/** Ends or cancels a handle that was made but not dragged. */
export function leaveHandle(store: Store, solver: SolverClient, phase: 'end' | 'cancel') {
  sendOfNew(solver, [], phase);
  store.set({ dragged: [] });
}

function sendOfNew(solver: SolverClient, vertices: number[], phase: 'make' | 'end' | 'cancel') {
  const targets = new Float64Array(0);
  solver.tell.drag({ vertices: Uint32Array.from(vertices), targets, phase });
}
