/**
 * `window.shapeUp`: API of the page for scripts, lessons and tests, with the names and units of the
 * report of the command line.
 */

import { pictureOf } from '../features/export/picture.ts';
import { turntableVideo } from '../features/export/turntable-video.ts';
import { handlesNow } from '../store/handles.ts';
import type { Store } from '../store/state.ts';
import type { SolverClient } from '../solver/solver-client.ts';
import type { Viewport } from '../viewport/viewport.ts';
import type { Files } from '../documents/files.ts';
import type { Loaded } from '../solver/types.ts';

export type ScriptApi = ReturnType<typeof scriptApi>;

declare global {
  interface Window {
    /** There once the page's script runs. */
    shapeUp: ScriptApi;
  }
}

/** Number of recent drag moves whose times are kept. */
const DRAGS_KEPT = 1000;

export function scriptApi(store: Store, solver: SolverClient, viewport: Viewport, files: Files) {
  const drags: { latency: number[]; answer: number[] } = { latency: [], answer: [] };
  solver.on('frame', ({ answers }) => {
    if (!answers) return;
    drags.latency.push(performance.now() - answers[0]);
    drags.answer.push(answers[1]);
    for (const times of Object.values(drags)) times.splice(0, times.length - DRAGS_KEPT);
  });
  /** @param at position in the view */
  const onPage = (at: ArrayLike<number> | undefined) => {
    const { left, top } = viewport.element.getBoundingClientRect();
    return at ? ([left + at[0], top + at[1]] as [number, number]) : null;
  };

  return {
    /**
     * Summary of the state. `energy` is that of the current shape, `constraints` are counts by
     * kind, and the indices in `handles` and `selection` count from 0.
     */
    state() {
      const state = store.get();
      const { document, numbers, running, converged, selection, renderer } = state;
      // The mesh arrives one message before its document: report both together.
      const model = document && state.model;
      const constraints: Record<string, number> = {};
      for (const { kind, count, enabled } of document?.constraints ?? []) {
        if (enabled) constraints[kind] = (constraints[kind] ?? 0) + count;
      }
      return {
        vertices: model?.vertices ?? 0,
        faces: model?.faces ?? 0,
        iteration: numbers?.iteration ?? 0,
        running,
        converged,
        energy: numbers?.energy ?? null,
        planarity: numbers?.planarity ?? null,
        circularity: numbers?.circularity ?? null,
        moved: numbers?.moved ?? null,
        exact: numbers?.exact ?? null,
        verdict: (!running && state.verdict?.report) || null,
        constraints,
        handles: handlesNow(state),
        selection: {
          vertices: [...selection.vertices],
          edges: [...selection.edges],
          faces: [...selection.faces],
        },
        renderer,
        threads: 1,
        last_step_ms: numbers?.stepMs ?? 0,
        problems: model?.problems ?? [],
        build: state.build,
      };
    },

    /** Resolves when the solver has processed all messages sent so far. */
    async settled() {
      await solver.ask.scene();
    },

    /** Resolves when the picture shows the result of all requests made so far. */
    async drawn() {
      // A frame may have been waiting for the previous picture.
      for (let turn = 0; turn < 2; turn++) {
        await solver.ask.scene();
        await new Promise(requestAnimationFrame);
      }
      viewport.refine();
      await new Promise(requestAnimationFrame);
    },

    /** The scene as a JSON object, at the last edit or the end of the last run. */
    scene() {
      return solver.sceneText === null ? null : JSON.parse(solver.sceneText);
    },

    /** A copy of the declarations of the kinds of constraint: see `KindWords` of Rust. */
    kinds() {
      return structuredClone(store.get().kinds);
    },

    /** A copy of the current positions, `#V by 3`, in file coordinates. */
    positions() {
      return solver.geometry?.positions.slice() ?? new Float64Array(0);
    },

    /**
     * Position of a vertex on the page, [x, y] in CSS pixels; null if hidden or outside. A moving
     * camera first jumps to its destination.
     */
    screen(vertex: number) {
      const at = viewport.with((view) => {
        viewport.arrive();
        return view.screen(vertex);
      });
      return onPage(at);
    },

    /**
     * Position on the page of a part of the gizmo: an axis `x`, `y`, `z`, or a plane `xy`, `yz`,
     * `zx`; null while it cannot be grabbed.
     */
    gizmo(part: string) {
      return onPage(viewport.with((view) => view.gizmoPart(part)));
    },

    /** A copy of the camera, in the format of `View.camera`; null before the first picture. */
    camera() {
      return store.get().camera?.slice() ?? null;
    },

    /**
     * Moves the camera at once.
     * @param camera as `camera` returns it
     */
    look(camera: number[]) {
      store.set({ camera: [...camera] });
    },

    /**
     * Times of the last drag moves in milliseconds: from pointer to new positions (`latency`), and
     * within it from the message to the solver to its answer (`answer`).
     */
    dragTimes() {
      return structuredClone(drags);
    },

    /**
     * A picture as a PNG, in the proportions of the view, with its width in pixels, up to 7680, the
     * background of the view, white or none (transparent), and with or without the legend.
     * @param options default: the width and background of the view, with the legend
     * @returns rejects if there is no renderer
     */
    async picture({
      width,
      ground = 'view',
      legend = true,
    }: {
      width?: number;
      ground?: 'view' | 'white' | 'none';
      legend?: boolean;
    } = {}): Promise<Blob> {
      const scale = (width ?? viewport.width) / viewport.width;
      return pictureOf(viewport, store.get(), { scale, ground, legend });
    },

    /** The visible lines as the text of an SVG file for print; nothing if there is no renderer. */
    lineDrawing: () => viewport.lineDrawing(),

    /**
     * A video (WebM) of one turn of the model.
     * @param seconds duration, by default 6
     * @returns rejects if the browser cannot record, or another model is opened
     */
    async turntable(seconds?: number): Promise<Blob> {
      return turntableVideo(viewport, files.replaced, seconds);
    },

    /**
     * Opens a mesh or a scene as the file input would.
     * @param textOrScene the text of a file, or a scene as an object
     * @param name file name, whose extension gives the format
     * @returns null if a later opening has taken its place; rejects if the file is refused
     */
    open(textOrScene: string | object, name?: string): Promise<Loaded | null> {
      const isText = typeof textOrScene === 'string';
      const text = isText ? textOrScene : JSON.stringify(textOrScene);
      const isScene = !isText || /^\s*\{/.test(text);
      const bytes = new TextEncoder().encode(text);
      return files.open([{ name: name ?? (isScene ? 'scene.shapeup.json' : 'mesh.obj'), bytes }]);
    },
  };
}
