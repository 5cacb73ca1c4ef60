/**
 * Messages between the page and the solver's worker, which exchange nothing else.
 *
 * Page to worker: a `Call` (`remote.ts`) of a method of `worker/interface.ts`, or `ping`, which is
 * answered by `pong` between slices. With an `id` a call is answered by exactly one `reply`, `refused` or
 * `outdated` with the same `id`. Worker to page: those answers, and the events of {@link FromWorker}.
 * Events caused by a call are sent before its answer, so that the page is up to date when its promise
 * settles; except `frame` and what follows it, which wait for a free buffer.
 *
 * The worker first sends `ready`, once; the page queues its messages until then.
 *
 * Meshes are numbered by their `model` messages, from 1, in each worker. A call has the number of the
 * mesh that the page shows: what is about another one, or another model, by now, is not done.
 *
 * Positions travel in two buffers of `#V by 3` numbers, which are transferred, never copied: the
 * worker writes one and sends it in a `frame`; the page returns the previous one with `recycle`
 * after drawing. Without a free buffer no frame is sent, so that there is at most one frame per
 * picture, and the solver never waits.
 *
 * Lengths are in the unit of the mesh, energies in its square, times in ms; indices count from 0.
 */

import type {
  FaceMeasure,
  KindWords,
  FrameNumbers,
  Operation,
  DrawnProjections,
  Document as SceneDocument,
  Setting,
} from '../pkg/engine/shape_up.js';
import type { Connectivity, Loaded, Measure } from './types.ts';

/**
 * - `ready`: the solver accepts messages. Sent first, once; `module` is the engine, compiled.
 * - `loading`: before that, the progress of fetching its module, if it takes long.
 * - `model`: another mesh is open, with the number `mesh`; without a name and files, the current mesh was
 *   refined or refining was undone. `positions` is one of the two buffers.
 * - `document`: after every edit and every load.
 * - `scene`: the scene file's text with its undo history, whenever it changed and the solver is
 *   idle: for autosave, to restore a worker that died, and for the second worker; `generation` is
 *   that of its problem and shape. `progress`: at intervals, the progress of a run or a drag since then.
 * - `frame`: a state of the iteration. `generation` is that of its problem and shape, as in `scene`,
 *   before or after which it may come. `values` are those of `measure`, `#F`, and `greatest` is the
 *   largest absolute one; `corners`, for measures of vertices, those of the vertices, `#V`, whose
 *   maximum a face has; `shapes` the fitted shapes, eight numbers each; `projections` the projected
 *   points of the constraints; `answers` the time of the latest drag move that it shows, and the
 *   milliseconds since it came.
 * - `activity`: whether the solver runs (Run was pressed and it has not converged); sent after the
 *   frame that belongs to it.
 * - `collapsed`: the run, or a single step, has ended with a collapsed shape (`collapse` tells how), not
 *   converged; sent after its `activity`.
 * - `trouble`: an iteration failed; the last good state stays.
 * - `dragEnded`: the drag with this number is over, or was refused; the document follows.
 * - `died`: the state is unusable, the worker must be replaced.
 * - `working`: work begins that may take long, with no message until then: for the call with this `id`, or
 *   for none, as a run. `pong`: sign of life.
 * - `refused`: `path` is the position of the error in the scene, such as `constraints[0].length`;
 *   empty if it is not about a scene. `outdated`: the call is about a model, or values of a mesh, that
 *   have been replaced.
 */
export type FromWorker =
  | {
      type: 'ready';
      kinds: KindWords[];
      measures: FaceMeasure[];
      operations: Operation[];
      settings: Setting[];
      module: WebAssembly.Module;
    }
  | { type: 'loading'; bytes: number; all: number }
  | {
      type: 'model';
      mesh: number;
      loaded: Loaded;
      connectivity: Connectivity;
      positions: Float64Array;
    }
  | { type: 'document'; document: SceneDocument }
  | { type: 'scene'; text: string; generation: number; history: Uint8Array; iteration: number }
  | { type: 'progress'; bytes: Uint8Array; iteration: number }
  | {
      type: 'frame';
      generation: number;
      numbers: FrameNumbers;
      positions: Float64Array;
      measure: Measure | null;
      greatest: number;
      values: Float32Array | null;
      corners: Float32Array | null;
      shapes: Float64Array | null;
      projections: DrawnProjections | null;
      answers: [number, number] | null;
    }
  | { type: 'activity'; running: boolean; converged: boolean }
  | { type: 'collapsed'; collapse: string }
  | { type: 'trouble'; message: string }
  | { type: 'dragEnded'; id: number }
  | { type: 'died'; message: string }
  | { type: 'working'; id?: number }
  | { type: 'pong' }
  | { type: 'reply'; id: number; value: unknown }
  | { type: 'refused'; id: number; message: string; path: string }
  | { type: 'outdated'; id: number };

/** The messages of the worker by their type. */
export type WorkerEvents = { [T in FromWorker['type']]: Extract<FromWorker, { type: T }> };
