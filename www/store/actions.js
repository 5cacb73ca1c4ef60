/**
 * Actions of the page on the solver, each with its status text and error handling. Buttons, keys,
 * panels and scripts all go through here.
 */

import { count, ended } from '../ui/format.js';
import { messageOf } from '../solver/messages.js';
import { createQueries } from './queries.js';
import { verticesOf } from './selection.js';
import { isHard } from './state.js';
import { createViewActions } from './view-actions.js';

/**
 * @param {import("./state.js").Store} store
 * @param {import("../solver/solver-client.js").SolverClient} solver
 * @param {import("../ui/controls/alerts.js").Alerts} alerts
 */
export function createActions(store, solver, alerts) {
  const view = createViewActions(store);
  const { setStatus } = view;

  /**
   * Reports an error in an alert; the result is undefined then.
   * @template T
   * @param {Promise<T> | T} promise
   * @returns {Promise<T | undefined>}
   */
  async function reportErrors(promise) {
    try {
      return await promise;
    } catch (error) {
      alerts.error(messageOf(error));
      return undefined;
    }
  }

  /**
   * @param {import("../solver/messages.js").Edit} change
   * @param {(error: unknown) => boolean} [showError] shows an error at its field; false if there is none
   * @returns {Promise<null | undefined>}
   */
  function edit(change, showError = () => false) {
    return attempt({ type: 'edit', edit: change }, showError);
  }

  /**
   * Adds one constraint kind to all panels, and runs until they are within the tolerance.
   * @param {string} kind
   * @param {number} [within] tolerance in the unit of the mesh, if other than the displayed one
   * @param {import("../solver/messages.js").PanelStart} [from] the shape to start from
   * @returns {Promise<null | undefined>}
   */
  function makePanels(kind, within, from = 'now') {
    const { tolerance: own, model } = store.get();
    const tolerance = within ?? own ?? model?.tolerance ?? 0;
    return attempt({ type: 'makePanels', kind, tolerance, from });
  }

  /**
   * @param {import("../solver/messages.js").Request & { type: "edit" | "makePanels" }} request
   * @param {(error: unknown) => boolean} [showError]
   * @returns {Promise<null | undefined>} undefined if refused
   */
  async function attempt(request, showError = () => false) {
    try {
      return await solver.request(request);
    } catch (error) {
      if (!showError(error)) alerts.error(messageOf(error));
      return undefined;
    }
  }

  /** Returns the selected vertices, ends of selected edges and corners of selected faces. */
  function selectedVertices() {
    const { geometry } = solver;
    return geometry ? verticesOf(store.get().selection, geometry.connectivity) : [];
  }

  const connectivity = () => solver.geometry?.connectivity;

  /** Returns the selected vertices that are handles. */
  function selectedHandles() {
    const { selection, document } = store.get();
    return (document?.handles ?? [])
      .map((handle) => handle.vertex)
      .filter((vertex) => selection.vertices.has(vertex));
  }

  /**
   * @param {number[]} vertices
   * @param {boolean} fixed
   */
  async function addHandles(vertices, fixed) {
    if (vertices.length === 0) return setStatus('Select a vertex first, then press H.');
    if ((await edit({ type: 'addHandles', vertices, fixed })) === undefined) return;
    setStatus(`${count(vertices.length, 'handle')} ${fixed ? 'fixed' : 'added'}`);
  }

  /** @param {number[]} vertices */
  async function removeHandles(vertices) {
    const handles = new Set(store.get().document?.handles.map((handle) => handle.vertex));
    const held = vertices.filter((vertex) => handles.has(vertex));
    if (held.length === 0) return setStatus('No handle is selected.');
    if ((await edit({ type: 'removeHandles', vertices: held })) === undefined) return;
    setStatus(`${count(held.length, 'handle')} removed`);
  }

  return {
    ...view,
    ...createQueries(solver, reportErrors),
    edit,
    makePanels,
    reportErrors,
    connectivity,
    selectedVertices,
    selectedHandles,
    addHandles,
    removeHandles,

    /**
     * Opens files; rejects with the error.
     * @param {Omit<Extract<import("../solver/messages.js").Request, { type: "open" }>, "type">} given
     */
    open: (given) => solver.request({ type: 'open', ...given }),

    runOrPause() {
      const { running, refining } = store.get();
      store.set({ refining: false });
      solver.send({ type: running || refining ? 'pause' : 'run' });
    },

    async step() {
      const converged = await reportErrors(solver.request({ type: 'step' }));
      if (converged === undefined) return;
      const { document, numbers } = store.get();
      const done = converged ? ended(true, numbers?.iteration ?? 0) : 'One iteration';
      const isInexact = document?.constraints.some(isHard) && !numbers?.exact?.met;
      setStatus(isInexact ? `${done}; Run makes it exact` : done);
    },

    /** Performs the local step, or the global step after it. */
    async halfStep() {
      const words = reportErrors(import('./half-step/half-step-words.js'));
      const done = await reportErrors(solver.request({ type: 'halfStep' }));
      const loaded = await words;
      if (done && loaded) setStatus(loaded.halfStepWords(done));
    },

    async reset() {
      if ((await edit({ type: 'reset' })) !== undefined) setStatus('Back to the original');
    },

    async undo() {
      const what = await reportErrors(solver.request({ type: 'undo' }));
      if (what) setStatus(`Undid: ${what}`);
    },

    async redo() {
      const what = await reportErrors(solver.request({ type: 'redo' }));
      if (what) setStatus(`Redid: ${what}`);
    },

    selectNextHandle() {
      const { document, selection } = store.get();
      const handles = (document?.handles ?? []).map(({ vertex }) => vertex);
      if (handles.length === 0) return setStatus('There is no handle yet.');
      const at = handles.findIndex((vertex) => selection.vertices.has(vertex));
      const next = handles[(at + 1) % handles.length];
      view.select({ vertices: [next], faces: [] });
    },

    /** @param {boolean} [ignoreCollapse] continue although the mesh has collapsed */
    run: (ignoreCollapse) => solver.send({ type: 'run', ignoreCollapse }),

    /**
     * Sends the new targets of handles.
     * @param {Pick<import("../solver/messages.js").Handle, "vertex" | "target">[]} handles
     * @param {"start" | "move" | "end"} phase
     */
    moveHandles(handles, phase) {
      const vertices = Uint32Array.from(handles, ({ vertex }) => vertex);
      const targets = Float64Array.from(handles.flatMap(({ target }) => target));
      solver.send({ type: 'drag', vertices, targets, phase });
    },
  };
}

/** @typedef {ReturnType<typeof createActions>} Actions */
