/**
 * Actions of the page on the solver, each with its status text and error handling. Buttons, keys,
 * panels and scripts all go through here.
 */

import { workingKey } from '../ui/keys.ts';
import { once } from '../ui/once.ts';
import { count } from '../ui/words.ts';
import { Cancelled, messageOf } from '../solver/errors.ts';
import { createTrials, type ExactFound } from './trials.ts';
import { halfStepWords } from './half-step.ts';
import type { ConstraintRow, Edit, PanelStart, Require } from '../pkg/engine/shape_up.js';
import { Drags, HANDLES_LOCKED, areHandlesLocked } from './handles.ts';
import { asksPanels } from './panels-card.ts';
import { existing, verticesOf } from './selection.ts';
import { isHard, type Store } from './state.ts';
import { createViewActions } from './view-actions.ts';
import type { JobsClient } from '../solver/jobs-client.ts';
import type { RowKey } from '../solver/rows.ts';
import type { SolverClient } from '../solver/solver-client.ts';
import type { Alerts, Offer } from '../ui/controls/alerts.tsx';

type ShowError = (error: unknown) => boolean | string;

export function createActions(
  store: Store,
  solver: SolverClient,
  jobs: JobsClient,
  alerts: Alerts,
) {
  const view = createViewActions(store);
  const { setStatus } = view;
  // A verdict on another shape is out of date, and so is one that no constraint asks for any more.
  const forget = () => {
    const isNow = store.get().verdict?.shape === solver.geometry?.generation;
    if (!isNow || !asksPanels(store.get())) store.set({ verdict: null });
  };
  solver.on('frame', forget);
  store.subscribe(['document'], forget);
  solver.on('model', () => store.set({ verdict: null }));

  /**
   * Reports an error in an alert; the result is undefined then.
   * @param offers what can be done about it
   */
  async function reportErrors<T>(
    promise: Promise<T> | T,
    ...offers: Offer[]
  ): Promise<T | undefined> {
    try {
      return await promise;
    } catch (error) {
      if (!(error instanceof Cancelled)) alerts.error(withoutPath(error), ...offers);
      return undefined;
    }
  }

  /**
   * Returns what a constraint acts on; undefined if it is gone, or an error is reported.
   * @param number of its row
   */
  async function members(number: number) {
    const { model } = store.get();
    const found = await reportErrors(solver.ask.members(number));
    return store.get().model === model ? (found ?? undefined) : undefined;
  }

  /** @param showError shows an error at its field; false if there is none, or the words of the alert */
  function edit(change: Edit, showError?: ShowError): Promise<null | undefined> {
    return attempt(solver.change.edit(change), showError);
  }

  /**
   * Edits a row of a list.
   * @param row what it keeps: in the solver, its index may be another one than that of the edit by then
   * @param showError see {@link edit}
   */
  const editRow = (row: RowKey, change: Edit, showError?: ShowError) =>
    attempt(solver.change.edit(change, row), showError);

  /**
   * Adds one constraint kind to all panels, and runs until they are within the tolerance.
   * @param within tolerance in the unit of the mesh, if other than the displayed one
   * @param from the shape to start from
   */
  function makePanels(
    kind: string,
    within?: number,
    from: PanelStart = 'now',
  ): Promise<null | undefined> {
    const tolerance = within ?? store.get().document?.tolerance ?? 0;
    return attempt(solver.change.makePanels(kind, tolerance, from));
  }

  /** Withdraws the message on the last edit that was refused. */
  let withdraw = () => {};

  /** @returns undefined if refused */
  async function attempt(
    change: Promise<null>,
    showError: ShowError = () => false,
  ): Promise<null | undefined> {
    try {
      const made = await change;
      // What was wrong with an earlier one is settled.
      withdraw();
      return made;
    } catch (error) {
      if (!(error instanceof Cancelled)) {
        const shown = showError(error);
        if (shown === true) return undefined;
        withdraw = alerts.error(shown || withoutPath(error));
      }
      // The controls show what was asked for: all show again what is.
      store.set({ refused: store.get().refused + 1 });
      return undefined;
    }
  }

  /** Returns the selected vertices, ends of selected edges and corners of selected faces. */
  function selectedVertices() {
    const { geometry } = solver;
    return geometry ? verticesOf(store.get().selection, geometry.connectivity) : [];
  }

  /** Positions of the original. */
  const ofModel = () => once(() => solver.ask.originalPositions());
  let original = ofModel();
  solver.on('model', () => (original = ofModel()));

  const connectivity = () => solver.geometry?.connectivity;

  /** Returns the selected vertices that are handles. */
  function selectedHandles() {
    const { selection, document } = store.get();
    return (document?.handles ?? [])
      .map((handle) => handle.vertex)
      .filter((vertex) => selection.vertices.has(vertex));
  }

  /** Makes or changes the handles at those of these vertices that `how` concerns. */
  async function hold(vertices: number[], how: keyof typeof HOLDS) {
    if (areHandlesLocked(store.get().document)) return setStatus(HANDLES_LOCKED);
    if (vertices.length === 0)
      return setStatus(`Select a vertex first, then press ${workingKey('H') || 'Make handle'}.`);
    const { handles = [] } = store.get().document ?? {};
    const known = new Map(handles.map((handle) => [handle.vertex, handle.fixed]));
    const { concerns, fixed, done } = HOLDS[how];
    // The others keep their weights and targets.
    const held = vertices.filter((vertex) => concerns(known.get(vertex)));
    if (held.length === 0) return setStatus(alreadyInWords(vertices.length, how));
    if ((await edit({ addHandles: { vertices: held, fixed } })) === undefined) return;
    setStatus(`${count(held.length, 'handle')} ${done}`);
  }

  /** Fixes vertices, or makes handles of those that are none. */
  const addHandles = (vertices: number[], fixed: boolean) => hold(vertices, fixed ? 'fix' : 'add');

  /** Does so with the selected vertices. */
  async function holdSelected(fixed: boolean) {
    await solver.settled();
    await addHandles(selectedVertices(), fixed);
  }

  /** Makes fixed handles soft. */
  const soften = (vertices: number[]) => hold(vertices, 'soften');

  async function softenSelected() {
    await solver.settled();
    await soften(selectedVertices());
  }

  /** Removes the selected handles. */
  async function releaseSelected() {
    await solver.settled();
    await removeHandles(selectedVertices());
  }

  async function removeHandles(vertices: number[]) {
    if (areHandlesLocked(store.get().document)) return setStatus(HANDLES_LOCKED);
    const handles = new Set(store.get().document?.handles.map((handle) => handle.vertex));
    const held = vertices.filter((vertex) => handles.has(vertex));
    if (held.length === 0) return setStatus('No handle is selected.');
    if ((await edit({ removeHandles: { vertices: held } })) === undefined) return;
    setStatus(`${count(held.length, 'handle')} removed`);
  }

  return {
    ...view,
    /** Questions to the solver, which leave document and shape as they are. */
    ask: solver.ask,

    /** Returns the positions at opening, `#V by 3`; asked for once. */
    originalPositions: () => original(),

    trials: createTrials(solver, jobs),
    drags: new Drags(store, solver),

    /** Ends a run; returns what is shown, for the second worker. */
    rest: solver.change.rest,
    /** Returns what is shown; null during a run or a drag. What looks by itself must end neither. */
    atRest: solver.change.atRest,

    /** Other shapes that are equally exact, shown and kept. */
    variations: {
      show: solver.change.showVariation,
      keep: () => reportErrors(solver.change.keepVariation()),
      leave: () => reportErrors(solver.change.leaveVariation()),
    },

    exact: {
      /** Sets the hardness of a row and runs, as one step of undo. */
      require: ({ index, number }: ConstraintRow, require: Require) =>
        attempt(solver.change.editAndRun({ setConstraint: { index, require } }, number)),

      /**
       * Applies a shape that was found, if it belongs to the current one.
       * @param unasked merges it into the last step of undo, and leaves the requirements as they are
       */
      accept: ({ shape, positions }: ExactFound, unasked: boolean) =>
        reportErrors(solver.change.makeExact(shape, positions, unasked)),
    },

    /** Passes numbers of the build of the shape that is shown, by id; goals of a lesson may bound them. */
    setBuildNumbers: (numbers: [string, number][]) =>
      solver.change.setBuildNumbers(
        solver.geometry?.positions ?? new Float64Array(0),
        numbers.map(([id]) => id),
        Float64Array.from(numbers, ([, value]) => value),
      ),
    edit,
    editRow,
    members,
    makePanels,
    reportErrors,
    connectivity,

    /** As `select` of the view, without what the mesh does not have; returns what is selected. */
    select(elements: Parameters<typeof view.select>[0]) {
      const found = existing(elements, solver.geometry);
      view.select(found);
      return found;
    },

    selectedVertices,
    selectedHandles,
    addHandles,
    soften,
    holdSelected,
    softenSelected,
    releaseSelected,

    /**
     * Resolves when the page shows the changes and selections begun before: what saves, builds or
     * acts on the selection waits for them.
     */
    settled: () => solver.settled(),

    /** Registers what the user has begun and the solver does not know of, so that `settled` waits for it. */
    begin: <T>(begun: Promise<T>) => solver.begin(begun),

    runOrPause() {
      const { running, refining } = store.get();
      store.set({ refining: false });
      solver.tell[running || refining ? 'pause' : 'run']();
    },

    async step() {
      const numbers = await reportErrors(solver.change.step());
      if (!numbers) return;
      const { document } = store.get();
      const done = numbers.converged ? numbers.ended.converged : 'One iteration';
      const isInexact = document?.constraints.some(isHard) && !numbers.exact?.met;
      setStatus(isInexact ? `${done}; press Run to satisfy what is required` : done);
    },

    /** Performs the local step, or the global step after it. */
    async halfStep() {
      const done = await reportErrors(solver.change.halfStep());
      if (done) setStatus(halfStepWords(done));
    },

    async reset() {
      if ((await edit('reset')) !== undefined) setStatus('Back to the original');
    },

    /** @returns the name of what was undone; null if there was nothing, undefined if refused */
    async undo() {
      store.set({ refining: false });
      const what = await reportErrors(solver.change.undo());
      if (what) setStatus(`Undid: ${what}`);
      return what;
    },

    /** @returns as {@link undo} */
    async redo() {
      store.set({ refining: false });
      const what = await reportErrors(solver.change.redo());
      if (what) setStatus(`Redid: ${what}`);
      return what;
    },

    selectNextHandle() {
      const { document, selection } = store.get();
      const handles = (document?.handles ?? []).map(({ vertex }) => vertex);
      if (handles.length === 0) return setStatus('There is no handle yet.');
      const at = handles.findIndex((vertex) => selection.vertices.has(vertex));
      const next = handles[(at + 1) % handles.length];
      view.select({ vertices: [next], faces: [] });
    },

    run: () => solver.tell.run(),
  };
}

/** The message on a refused edit, without its place in a scene file, of which the page shows nothing. */
export function withoutPath(error: unknown) {
  const message = messageOf(error);
  const path = error instanceof Error && 'path' in error ? `${String(error.path)}: ` : '';
  return path.length > 2 && message.startsWith(path) ? message.slice(path.length) : message;
}

/**
 * Which vertices are concerned, by whether their handles are fixed (undefined without one), what
 * becomes of them, and its words.
 */
const HOLDS = {
  add: { concerns: (fixed?: boolean) => fixed === undefined, fixed: false, done: 'added' },
  fix: { concerns: (fixed?: boolean) => fixed !== true, fixed: true, done: 'fixed' },
  soften: { concerns: (fixed?: boolean) => fixed === true, fixed: false, done: 'made soft' },
};

/** Says that there was nothing to do. */
function alreadyInWords(vertices: number, how: keyof typeof HOLDS) {
  if (how === 'soften') return 'No fixed handle is selected.';
  const what = how === 'fix' ? 'fixed' : vertices === 1 ? 'a handle' : 'handles';
  return `${count(vertices, 'vertex is', 'vertices are')} already ${what}`;
}

export type Actions = ReturnType<typeof createActions>;
