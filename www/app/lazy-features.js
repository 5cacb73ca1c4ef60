/** Parts of the page that come with the first model, state or press that needs them. */

import { messageOf } from '../solver/messages.js';
import { sizeOfSelection } from '../store/selection.js';
import { byId } from '../ui/dom.js';

/** @typedef {import("../store/state.js").State} State */

/**
 * @param {import("./context.js").AppContext} app
 * @param {import("../store/mesh-queries.js").Selecting} selecting
 */
export function loadWhenNeeded(app, selecting) {
  const { store, solver, viewport, files, alerts } = app;
  const loaded = (/** @type {Promise<unknown>} */ part) =>
    void part.catch((error) => alerts.error(messageOf(error)));

  /**
   * Loads a part the first time that something holds.
   * @param {(keyof State)[]} keys that it depends on
   * @param {(state: Readonly<State>) => unknown} holds
   * @param {() => Promise<unknown>} load
   */
  function when(keys, holds, load) {
    let isDone = false;
    store.subscribe(keys, (state) => {
      if (isDone || !holds(state)) return;
      isDone = true;
      loaded(load());
    });
  }

  files.once('opened', () =>
    loaded(import('../features/warnings.js').then((it) => it.watchConditions(app))),
  );
  files.once('opened', () =>
    loaded(import('../features/make-panels/card.js').then((it) => new it.MakePanels(app))),
  );
  solver.on('collapsed', ({ collapse }) =>
    loaded(import('../documents/collapse.js').then((it) => it.reportCollapse(app, collapse))),
  );
  when(
    ['document'],
    ({ document }) => document?.free && document.constraints.length > 0,
    () => import('../features/free-vertices.js').then((it) => it.watchFreeVertices(app)),
  );
  when(
    ['document'],
    ({ document }) => document?.lesson,
    () => import('../features/lesson/panel.js').then((it) => it.lessonPanel(app)),
  );
  when(
    ['example'],
    ({ example }) => example?.experiment,
    () =>
      import('../features/experiment/offer.js').then((it) =>
        it.offerExperiment(byId('experiment'), app),
      ),
  );
  when(
    ['tool', 'selection'],
    ({ tool, selection }) => tool === 'select' || sizeOfSelection(selection) > 0,
    () =>
      import('../panels/select-bar/select-bar.js').then((it) =>
        it.selectBar(byId('select-bar'), byId('select-menu'), app, selecting),
      ),
  );
  when(
    ['moved'],
    ({ moved }) => moved,
    () => import('../viewport/input/drag-label.js').then((it) => it.showMoved(viewport, store)),
  );
  if (matchMedia('(any-pointer: coarse)').matches)
    loaded(import('../ui/controls/tooltips.js').then((it) => it.tooltipsForTouch()));
}
