/** Types of what crosses between the page and the engine, beside those of Rust. */

export type { Asker, Built, Reshaped } from '../worker/jobs/build.ts';
export type { Lines, Question as LinesQuestion } from '../worker/jobs/curvature.ts';

/** A model: `guessed` are unit and axis as they were guessed, null where the file states them. */
export type Loaded = Omit<import('../pkg/engine/shape_up.js').Loaded, 'guessed'> & {
  guessed: { units: string | null; up: 'y' | 'z' | null };
};

/**
 * A model as it was opened: `files` are those it was opened from; `undoLost` is the reason why its saved
 * undo history is lost, or empty.
 */
export type Opened = Loaded & { files: string[]; undoLost: string };

/** The id of a `FaceMeasure` of Rust. */
export type Measure = string;

/** The connectivity of the mesh, sent once. */
export interface Connectivity {
  /** `#F + 1` */
  faceOffsets: Uint32Array;
  faceIndices: Uint32Array;
  /** of faces that are left as they are: their number plus one */
  untouchedOffsets: Uint32Array;
  /** vertices whose positions are guesses, since the file has none */
  unplaced: Uint32Array;
  /** `#curves + 1` */
  curveOffsets: Uint32Array;
  curveIndices: Uint32Array;
  /** `#E by 2` */
  edges: Uint32Array;
}

/** The text of the scene with its mesh, which has this generation in the solver. */
export type Snapshot = { text: string; generation: number };

export type NamedBytes = { name: string; bytes: Uint8Array };

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
 * Targets (`#vertices by 3`; none if nothing moves) of dragged handles, of the drag with the number `id`. The first phase is
 * `start`, or `make`, which makes the vertices handles first. Of several `move`s only the last one
 * counts; `time` is that of its event. During a drag the solver iterates even when paused.
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
