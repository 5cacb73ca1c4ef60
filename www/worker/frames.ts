/**
 * Frames for the page: positions in two buffers that travel back and forth, and the other requested
 * data. Without a free buffer no frame is sent.
 */

import type { FromWorker } from '../solver/events.ts';
import type { Measure } from '../solver/types.ts';
import type { Solver, DrawnProjections } from '../pkg/engine/shape_up.js';

/** What is sent with each frame besides positions. */
export interface Shown {
  measure: Measure | null;
  shapes: boolean;
  projections: boolean;
  corners: boolean;
}

export class Frames {
  /** Whether the state has changed since the last frame. */
  due = false;
  shown: Shown = { measure: null, shapes: false, projections: false, corners: false };

  #solver;
  #post;
  /** Buffers available for writing. */
  #free: Float64Array[] = [];

  constructor(solver: Solver, post: (message: FromWorker, transfer?: Transferable[]) => void) {
    this.#solver = solver;
    this.#post = post;
  }

  /**
   * Starts with another mesh.
   * @returns the first of the two buffers, filled with its positions
   */
  renew(vertices: number): Float64Array {
    this.#free = [new Float64Array(3 * vertices)];
    const positions = new Float64Array(3 * vertices);
    this.#solver.writePositions(positions);
    return positions;
  }

  /** Takes a buffer of this mesh back. */
  takeBack(positions: Float64Array) {
    this.#free.push(positions);
  }

  /**
   * Sends the state of the iteration, if it has changed and a buffer is free.
   * @param answers the move of a drag that the frame shows
   * @param iterating whether more frames follow
   * @returns whether it was sent
   */
  send(answers: () => [number, number] | null, iterating: boolean): boolean {
    const positions = this.#free.at(-1);
    if (!this.due || !positions) return false;
    const solver = this.#solver;
    const { measure, shapes, projections, corners } = this.shown;
    solver.writePositions(positions);
    const found = measure ? solver.faceValues(measure) : null;
    const parts = {
      values: found?.values ?? null,
      corners: (measure && corners && solver.cornerValues(measure)) || null,
      shapes: shapes ? solver.fitted() : null,
    };
    const projected: DrawnProjections | null = projections ? solver.projections() : null;
    this.#free.pop();
    const arrays = [positions, ...Object.values(parts), ...Object.values(projected ?? {})];
    this.#post(
      {
        ...{ type: 'frame', numbers: solver.frame(iterating), positions, measure },
        generation: solver.generation(),
        greatest: found?.greatest ?? 0,
        ...{ ...parts, projections: projected, answers: answers() },
      },
      arrays.flatMap((array) => array?.buffer ?? []),
    );
    this.due = false;
    return true;
  }
}
