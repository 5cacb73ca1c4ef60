/** Types of what crosses between the page and the engine, beside those of Rust. */

import type { Loaded } from '../pkg/engine/shape_up.js';

export type { Connectivity, Loaded } from '../pkg/engine/shape_up.js';
export type { PartsOwner, Built, Reshaped } from '../worker/jobs/build.ts';
export type { Lines, Question as LinesQuestion } from '../worker/jobs/curvature.ts';

/**
 * A model as it was opened: `files` are those it was opened from; `undoLost` is the reason why its saved
 * undo history is lost, or empty.
 */
export type Opened = Loaded & { files: string[]; undoLost: string };

/** The id of a `FaceMeasure` of Rust. */
export type Measure = string;

/** The text of the scene with its mesh, which has this generation in the solver. */
export type Snapshot = { text: string; generation: number };

export type NamedBytes = { name: string; bytes: Uint8Array<ArrayBuffer> };

/** Data saved with a scene to resume it; the byte arrays are read by the solver only. */
export interface Saved {
  /** of the scene */
  iteration: number;
  /** its undo and redo steps */
  history: Uint8Array | null;
  /** of a run or a drag that started from the scene */
  progress: Uint8Array | null;
}

/**
 * Targets (`#vertices by 3`; none if nothing moves) of dragged handles, of the drag with the number `id`.
 * The first phase is `start`, or `make`, which makes the vertices handles first. Of several `move`s only
 * the last one counts; `time` is that of its event. During a drag the solver iterates even when paused.
 */
export type Drag = {
  id: number;
  vertices: Uint32Array;
  targets: Float64Array;
  time?: number;
  phase: import('../pkg/engine/shape_up.js').DragPhase;
};

/** All build settings; a scene contains only those that differ from the default. */
export type BuildSettings = Required<import('../pkg/engine/shape_up.js').BuildSettings>;
