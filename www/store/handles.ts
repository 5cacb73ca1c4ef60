/** The handles as the page shows them, whether they can be dragged, and drags of them. */

import { isLocked } from './panels-card.ts';
import type { HandleRow, Document as SceneDocument } from '../pkg/engine/shape_up.js';
import type { Drag } from '../solver/types.ts';
import type { State, Store } from './state.ts';
import type { SolverClient } from '../solver/solver-client.ts';

/** Why no drag begins where {@link areHandlesLocked}. */
export const HANDLES_LOCKED = 'Locked by the lesson: the handles stay as they are.';

/** Returns the handles, with the current targets of dragged ones. */
export function handlesNow({
  document,
  dragged,
  moved,
}: Pick<State, 'document' | 'dragged' | 'moved'>): HandleRow[] {
  const handles = document?.handles ?? [];
  return moved ? withTargets(handles, dragged, moved.targets) : handles;
}

/** @param targets of the vertices, `#vertices by 3` */
function withTargets(handles: HandleRow[], vertices: ArrayLike<number>, targets: Float64Array) {
  const offsets = new Map(Array.from(vertices, (vertex, i) => [vertex, 3 * i]));
  return handles.map((handle): HandleRow => {
    const [x, y, z] = targets.subarray(offsets.get(handle.vertex) ?? targets.length);
    return z === undefined ? handle : { ...handle, target: [x, y, z] };
  });
}

/** Whether a lesson locks the handles. */
export const areHandlesLocked = (document: SceneDocument | null) =>
  isLocked({ document }, 'handles');

/** Names a handle that can be dragged, by its colour in the view; empty if there is none, or no view. */
export function draggableInWords({ document, renderer }: Pick<State, 'document' | 'renderer'>) {
  const handles = document?.handles ?? [];
  if (handles.length === 0 || areHandlesLocked(document) || renderer === 'none') return '';
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

/** Begins the drags of handles. There is one at a time: each ends the one before. */
export class Drags {
  #store;
  #solver;
  #begun = 0;
  #current: HandleDrag | null = null;

  constructor(store: Store, solver: SolverClient) {
    this.#store = store;
    this.#solver = solver;
    solver.on('dragEnded', ({ id }) => {
      if (this.#current?.id === id) this.#leave();
    });
    // No drag outlasts its model.
    solver.on('model', () => this.#leave());
  }

  /** Leaves the drag, unless it has ended: the answer to its end comes later. */
  #leave() {
    if (!this.#current?.isOver) this.#current?.leave();
  }

  /** Begins a drag of handles whose targets are known. */
  begin(handles: HandleRow[]): HandleDrag {
    return this.#begin((of) => new HandleDrag(of, handles));
  }

  /**
   * Begins a drag in the view.
   * @param vertex the handle under the pointer, or one of those at the gizmo
   * @param part of the gizmo
   */
  hold(constrain: MoveConstraint, vertex: number, part?: string): ViewDrag {
    return this.#begin((of) => new ViewDrag(of, movedWith(of.store, vertex), constrain, part));
  }

  /**
   * Makes a vertex a handle and drags it, from where the page shows it: moves need not wait for the
   * document that has the handle. This is one step of undo.
   */
  make(constrain: MoveConstraint, vertex: number): ViewDrag {
    return this.#begin((of) => {
      const positions = of.solver.geometry?.positions.subarray(3 * vertex, 3 * vertex + 3) ?? [];
      const [x, y, z] = positions;
      const others = movedWith(of.store, vertex).filter((handle) => handle.vertex !== vertex);
      const held = [{ vertex, target: [x, y, z] } as const, ...others];
      return new ViewDrag(of, held, constrain, undefined, vertex);
    });
  }

  #begin<T extends HandleDrag>(begin: (of: Owner) => T): T {
    // First, since the next one may begin at the targets of this one.
    this.#current?.end();
    const drag = begin({ store: this.#store, solver: this.#solver, id: ++this.#begun });
    this.#current = drag;
    return drag;
  }
}

/** The handles that move with one: the selected ones, if it is selected. */
function movedWith(store: Store, vertex: number) {
  const { document, selection } = store.get();
  const isSelected = selection.vertices.has(vertex);
  return (document?.handles ?? []).filter((handle) =>
    isSelected ? selection.vertices.has(handle.vertex) : handle.vertex === vertex,
  );
}

/** What a drag is begun with; `id` tells it from the others. */
type Owner = { store: Store; solver: SolverClient; id: number };
type Held = { vertex: number; target: readonly [number, number, number] };

/**
 * A drag of handles, one step of undo. It is over when it is ended or cancelled, when another one
 * begins, or when the solver has refused or ended it.
 */
export class HandleDrag {
  readonly id;
  /** Resolves when it is over. */
  readonly ended: Promise<void>;
  isOver = false;
  protected store;
  protected solver;
  #vertices;
  /** Targets at the start, `#vertices by 3`. */
  protected from: Float64Array;
  /** Current targets; the same array until they move. */
  #targets: Float64Array;
  #resolve = () => {};

  /**
   * @param held the handles, at their targets
   * @param made one of them that is no handle yet
   */
  constructor({ store, solver, id }: Owner, held: readonly Held[], made?: number) {
    this.id = id;
    this.store = store;
    this.solver = solver;
    this.ended = new Promise<void>((resolve) => (this.#resolve = resolve));
    this.#vertices = Uint32Array.from(held, ({ vertex }) => vertex);
    this.from = Float64Array.from(held.flatMap(({ target }) => target));
    this.#targets = this.from;
    if (made === undefined) this.#send('start');
    else this.#send('make', Uint32Array.of(made));
  }

  protected get hasMoved() {
    return this.#targets !== this.from;
  }

  /**
   * @param targets `#vertices by 3`
   * @param time of the event, on the clock of `performance.now()`
   */
  moveTo(targets: Float64Array, time?: number) {
    if (this.isOver) return;
    this.#targets = targets;
    this.#send('move', this.#vertices, time);
  }

  /** @returns whether anything has moved */
  end(): boolean {
    if (this.isOver) return false;
    this.#send('end');
    const { document } = this.store.get();
    // Valid until the solver sends the new document.
    const handles = withTargets(document?.handles ?? [], this.#vertices, this.#targets);
    if (document) this.store.set({ document: { ...document, handles } });
    this.leave();
    return this.#targets.some((value, i) => value !== this.from[i]);
  }

  /** Cancels the drag and restores the targets. */
  cancel() {
    if (this.isOver) return;
    this.#send('cancel');
    this.leave();
  }

  /** Ends it here: it is over in the solver. */
  leave() {
    this.isOver = true;
    this.#resolve();
  }

  #send(phase: Drag['phase'], vertices: Uint32Array = this.#vertices, time?: number) {
    // What has not moved stays where it is in the solver.
    const targets = this.hasMoved ? this.#targets.slice() : new Float64Array(0);
    this.solver.tell.drag({ id: this.id, vertices: vertices.slice(), targets, phase, time });
  }
}

/** A drag in the view, which shows it before the solver answers. */
export class ViewDrag extends HandleDrag {
  #constrain;
  /** Displacement of the pointer since the start. */
  #by: [number, number] = [0, 0];
  /** The axis or plane of the gizmo being dragged. */
  #part;
  #plane = 'screen';
  /** The axis to which a key restricts the handle: 0, 1, 2 or none. */
  #axis: number | null = null;

  constructor(
    owner: Owner,
    held: readonly Held[],
    constrain: MoveConstraint,
    part?: string,
    made?: number,
  ) {
    super(owner, held, made);
    this.#constrain = constrain;
    this.#part = part;
    const dragged = held.map(({ vertex }) => vertex);
    // A message about a finished run is outdated.
    owner.store.set({ dragged, gizmoPart: part, status: '' });
  }

  /**
   * @param dx pixels to the right since the beginning
   * @param dy pixels down
   * @param time of the event, on the clock of `performance.now()`
   */
  move(dx: number, dy: number, time: number = performance.now()) {
    if (this.isOver) return;
    this.#by = [dx, dy];
    // A press alone moves nothing.
    if (!dx && !dy && !this.hasMoved) return;
    const direction = this.#axis !== null ? AXES[this.#axis] : (this.#part ?? this.#plane);
    const moved = this.#constrain(direction, dx, dy);
    // Near the horizon of the plane a pixel is arbitrarily far: the handle stays.
    if (!moved) return;
    const targets = this.from.map((value, i) => value + moved[i % 3]);
    // The dots follow the pointer at once, the mesh when the solver answers.
    this.store.set({ moved: { by: [...moved], targets }, gizmoPart: direction });
    this.moveTo(targets, time);
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

  override leave() {
    super.leave();
    this.store.set({ dragged: [], moved: null, gizmoPart: undefined });
  }
}
