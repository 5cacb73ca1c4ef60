/**
 * `window.shapeUp`: the page for scripts, lessons and tests, in the words and units of the command
 * line's report.
 */

import { handlesNow } from '../store/state.js';

/** So many moves of drags are kept. */
const DRAGS_KEPT = 1000;

/**
 * @param {import("../store/state.js").Store} store
 * @param {import("../solver/solver-client.js").SolverClient} solver
 * @param {import("../viewport/viewport.js").Viewport} viewport
 * @param {import("../documents/files.js").Files} files
 */
export function scriptApi(store, solver, viewport, files) {
  /** @type {{ latency: number[], answer: number[] }} */
  const drags = { latency: [], answer: [] };
  solver.on('frame', ({ answers }) => {
    if (!answers) return;
    drags.latency.push(performance.now() - answers[0]);
    drags.answer.push(answers[1]);
    for (const times of Object.values(drags)) times.splice(0, times.length - DRAGS_KEPT);
  });
  /** @param {ArrayLike<number> | undefined} at on the view */
  const onPage = (at) => {
    const { left, top } = viewport.element.getBoundingClientRect();
    return at ? [left + at[0], top + at[1]] : null;
  };

  return {
    /**
     * Everything at a glance. `energy` is of the current shape; `constraints` counts by kind;
     * `handles` and `selection` name vertices and faces from 0.
     */
    state() {
      const state = store.get();
      const { document, numbers, running, converged, selection, renderer } = state;
      // A mesh comes a message before its document: whoever sees one sees both.
      const model = document && state.model;
      /** @type {Record<string, number>} */
      const constraints = {};
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
        constraints,
        handles: handlesNow(state),
        selection: {
          vertices: [...selection.vertices],
          edges: [...selection.edges],
          faces: [...selection.faces],
        },
        renderer: renderer === 'starting' ? 'none' : renderer,
        threads: 1,
        last_step_ms: numbers?.stepMs ?? 0,
        problems: model?.problems ?? [],
        build: state.build,
      };
    },

    /** Resolves when the solver has answered all that it was told so far. */
    async settled() {
      await solver.request({ type: 'scene' });
    },

    /** Resolves when the picture shows all that was asked for so far. */
    async drawn() {
      // A frame may have waited for the picture before it.
      for (let turn = 0; turn < 2; turn++) {
        await solver.request({ type: 'scene' });
        await new Promise(requestAnimationFrame);
      }
      viewport.refine();
      await new Promise(requestAnimationFrame);
    },

    /** The scene as JSON (an object), as of the last edit or the end of the last run. */
    scene() {
      return solver.sceneText === null ? null : JSON.parse(solver.sceneText);
    },

    /** The kinds of constraint as they are declared: see `KindInfo` in `messages.js`. A copy. */
    kinds() {
      return structuredClone(store.get().kinds);
    },

    /** The current shape, `#V by 3`, in file coordinates: a copy. */
    positions() {
      return solver.geometry?.positions.slice() ?? new Float64Array(0);
    },

    /**
     * Where a vertex is on the page, [x, y] in CSS pixels; null when it is hidden or outside. The camera is where
     * it is going to be.
     * @param {number} vertex
     */
    screen(vertex) {
      const at = viewport.with((view) => {
        view.arrive();
        return view.screen(vertex);
      });
      return onPage(at);
    },

    /**
     * Where a part of the gizmo is on the page: an axis `x`, `y`, `z`, or a plane `xy`, `yz`, `zx`; null
     * while it cannot be taken.
     * @param {string} part
     */
    gizmo(part) {
      return onPage(viewport.with((view) => view.gizmoPart(part)));
    },

    /**
     * Of the last moves of drags, in milliseconds: from the pointer to new positions (`latency`), and
     * of that, from when the solver was told to when it answered (`answer`).
     */
    dragTimes() {
      return structuredClone(drags);
    },

    /**
     * A picture of the view as a PNG: of a width in pixels up to 7680, in its proportions; on the ground of the
     * view, on white or on nothing (transparent); with the legend or without.
     * @param {{ width?: number, ground?: "view" | "white" | "none", legend?: boolean }} [options] the width of
     *   the view, its ground, with the legend
     * @returns {Promise<Blob>} rejects where nothing can draw
     */
    async picture({ width, ground = 'view', legend = true } = {}) {
      const { pictureOf } = await import('../features/export/picture.js');
      const scale = (width ?? viewport.width) / viewport.width;
      return pictureOf(viewport, store.get(), { scale, ground, legend });
    },

    /** The lines that are seen, as the text of an SVG file for print; nothing where nothing can draw. */
    lineDrawing: () => viewport.lineDrawing(),

    /**
     * A film (WebM) in which the model turns once.
     * @param {number} [seconds] that it takes, 6 if none are given
     * @returns {Promise<Blob>} rejects where the browser cannot record
     */
    async turntable(seconds) {
      const { turntableVideo } = await import('../features/export/turntable-video.js');
      return turntableVideo(viewport, seconds);
    },

    /**
     * Opens a mesh or a scene as the file input would.
     * @param {string | object} textOrScene the text of a file, or a scene as an object
     * @param {string} [name] decides how the text is read
     * @returns {Promise<import("../solver/messages.js").Loaded>} rejects when it is refused
     */
    open(textOrScene, name) {
      const isText = typeof textOrScene === 'string';
      const text = isText ? textOrScene : JSON.stringify(textOrScene);
      const isScene = !isText || /^\s*\{/.test(text);
      const bytes = new TextEncoder().encode(text);
      return files.open([{ name: name ?? (isScene ? 'scene.shapeup.json' : 'mesh.obj'), bytes }]);
    },
  };
}
