/**
 * The page: makes its parts and connects them. The solver's worker and the view's module start at
 * the same time and neither waits for the other.
 */

import { createActions } from './actions.js';
import { Alerts } from './alerts.js';
import { analysisRegion } from './analysis.js';
import { colourFaces } from './colouring.js';
import { commandTable } from './command-table.js';
import { bindButtons, bindKeys, bindRunButton, takeEarlyPresses } from './commands.js';
import { byId } from './dom.js';
import { offerExperiment } from './experiment/offer.js';
import { Files } from './files.js';
import { animateFirstPicture } from './first-picture.js';
import { toggleFlatMap } from './flat-map.js';
import { ended } from './format.js';
import { attachLater } from './attach-later.js';
import { bindHandleKeys } from './handle-keys.js';
import { firstHints } from './hints.js';
import { arrangeForWidth } from './layout.js';
import { messageOf } from './messages.js';
import { constraintsPanel } from './panels/constraints.js';
import { displayPanel } from './panels/display.js';
import { energiesPanel } from './panels/energies.js';
import { exampleNote } from './panels/example.js';
import { Keeping } from './keeping.js';
import { showMoved } from './moved-value.js';
import { handlesPanel } from './panels/handles.js';
import { bindHalfStepButtons } from './half-step.js';
import { HoldOriginal } from './hold-original.js';
import { stayOffline } from './offline.js';
import { modelPanel } from './panels/model.js';
import { statusBar } from './panels/status-bar.js';
import { selectBar } from './panels/select-bar.js';
import { PointerInput } from './pointer.js';
import { RegionSelection } from './region-selection.js';
import { colourRows } from './row-colours.js';
import { sizeOf } from './rounding.js';
import { scriptApi } from './script-api.js';
import { Selecting } from './selecting.js';
import { NOTHING } from './selection.js';
import { SolverClient } from './solver-client.js';
import { splitInto, toggleSplit } from './split.js';
import { recentMenu } from './recent-menu.js';
import { createStore } from './state.js';
import { followTheme } from './theme.js';
import { bindViewMenu } from './view-commands.js';
import { bindViewKeys } from './view-keys.js';
import { offerReport, tellUncaught } from './uncaught.js';
import { Viewport } from './viewport.js';

const store = createStore();
followTheme(store);
const alerts = new Alerts(byId('alert'));
tellUncaught(alerts, store);
const solver = new SolverClient();
takeUp(solver);

animateFirstPicture(store, solver);
const viewport = new Viewport(byId('viewport'), store, solver);
const files = new Files(store, solver, alerts);
const actions = createActions(store, solver, alerts);
const region = new RegionSelection(store, viewport);
const selecting = new Selecting(store, solver, actions);
const pointer = new PointerInput(store, solver, viewport, region, {
  addHandles: (vertices) => actions.addHandles(vertices, false),
  chosenHandles: actions.chosenHandles,
  showMenu: (at) =>
    actions.told(
      import('./context-menu.js').then(({ showContextMenu }) =>
        showContextMenu(at, { store, viewport, actions, selecting, commands }),
      ),
    ),
  fitAll: () => viewport.with((view) => view.fit()),
  doubleClick: (...what) => selecting.doubleClick(...what),
});
bindHandleKeys(viewport, store, solver, actions);
bindViewKeys(viewport);
showMoved(viewport, store);
const { fit } = colourFaces(store, solver);
colourRows(store, solver, actions);

modelPanel(byId('model'), store, actions, () => analysis.bring('log'));
offerExperiment(byId('experiment'), store, solver, alerts);
constraintsPanel(byId('constraints'), store, solver, actions);
handlesPanel(byId('handles'), store, actions, solver);
energiesPanel(byId('energies'), store, actions);
displayPanel(byId('display'), store);
viewport.addEventListener('ready', showLegend, { once: true });
const hold = new HoldOriginal(store, solver);
const parts = { store, solver, viewport, files, actions, alerts, hold };
const analysis = analysisRegion(byId('analysis'), parts);
exampleNote(byId('example-note'), files, alerts, ({ split, plot }) => {
  if (split) splitInto(parts, split);
  if (plot) analysis.bring(plot);
});
store.subscribe(['status'], ({ status }) => status && alerts.note(status));
attachLater(parts);
statusBar({ status: byId('status'), hint: byId('hint'), numbers: byId('numbers') }, store);
selectBar(byId('select-bar'), byId('select-menu'), store, actions, selecting, alerts);
firstHints(byId('hint-card'), store);
arrangeForWidth(store);

/** @type {HTMLInputElement} */
const fileInput = byId('file');
fileInput.addEventListener('change', async () => {
  const chosen = [...(fileInput.files ?? [])];
  // So that the same file can be opened again after it changed on disk.
  fileInput.value = '';
  await files.openFiles(chosen);
});
files.acceptDrops(byId('drop-overlay'));

/** @type {import("./commands.js").Command[]} */
const commands = commandTable({
  store,
  viewport,
  pointer,
  files,
  actions,
  alerts,
  solver,
  hold,
  fileInput,
  lesson: () => actions.told(import('./lesson/dialog.js').then(({ write }) => write(parts))),
  // What it lists is complete by the time that somebody looks.
  help: () => import('./help.js').then(({ showHelp }) => showHelp(byId('help'), commands)),
  flatMap: () => toggleFlatMap({ store, solver, viewport, alerts }),
  split: () => toggleSplit(parts),
});
for (const button of document.querySelectorAll('[data-command="reset"]'))
  if (button instanceof HTMLElement) hold.bind(button, { clicks: true });
bindButtons(commands, store);
bindKeys(commands, store);
bindRunButton(byId('run'), store);
bindHalfStepButtons(store);
/** @type {Window & { earlyPresses?: string[] }} index.html gathers them */
const early = window;
takeEarlyPresses(commands, store, early.earlyPresses ?? []);
delete early.earlyPresses;
bindViewMenu(byId('view-menu'), byId('view-menu-button'), commands, store);
selecting.bindKeys(commands);

viewport.addEventListener('none', (event) => {
  const { detail } = /** @type {CustomEvent} */ (event);
  import('./no-picture.js').then((module) => module.tellWhy(detail));
});

Object.assign(window, { shapeUp: scriptApi(store, solver, viewport, files) });

const keeping = new Keeping(solver, files, alerts, { store, analysis });
recentMenu(byId('recent-button'), byId('recent'), keeping);
keeping.begin().catch((error) => alerts.error(messageOf(error)));
files.offerExamples(byId('examples')).catch((error) => alerts.error(messageOf(error)));
stayOffline(alerts, keeping, viewport);
import('./surroundings.js').then((module) => module.tellSurroundings(byId('numbers'), store));

/** The legend comes when there is something to see. */
function showLegend() {
  const legend = import('./panels/legend.js');
  actions.told(legend.then(({ legend }) => legend(byId('legend'), store, viewport, fit)));
}

/**
 * Takes the solver's news into the store.
 * @param {SolverClient} client
 */
function takeUp(client) {
  /**
   * @template {import("./messages.js").FromWorker["type"]} Type
   * @param {Type} type
   * @param {(message: Extract<import("./messages.js").FromWorker, { type: Type }>) => void} take
   */
  const on = (type, take) =>
    client.addEventListener(type, (event) => take(/** @type {CustomEvent} */ (event).detail));

  on('ready', ({ kinds, elements, measures, operations, settings }) =>
    store.set({ kinds, elements, measures, operations, settings }),
  );
  on('model', ({ loaded, positions }) =>
    store.set({
      // In another worker it is looked at as before.
      ...(!client.restoring && {
        ...{ camera: null, measureChosen: false },
        ...{ tolerance: loaded.tolerance || null, tolerances: {} },
      }),
      model: loaded,
      size: sizeOf(positions),
      document: null,
      numbers: null,
      halfway: false,
      flatMap: null,
      split: null,
      heldOriginal: null,
      selection: NOTHING,
      dragged: [],
      dragMs: 0,
      tint: null,
      tape: null,
    }),
  );
  on('loading', ({ bytes, all }) =>
    import('./loading.js').then(({ showLoading }) => showLoading(store, bytes, all)),
  );
  on('document', ({ document }) => store.set({ document }));
  on('frame', ({ numbers, answers }) =>
    store.set({
      ...{ numbers, halfway: numbers.halfway },
      ...(answers && { dragMs: performance.now() - answers[0] }),
    }),
  );
  on('activity', ({ running, converged }) => {
    const before = store.get();
    store.set({ running, converged });
    // A drag comes to rest as well, but whoever drags is told of the handle.
    if (running === before.running) return;
    const { iteration = 0 } = before.numbers ?? {};
    store.set({ status: running ? 'Running' : ended(converged, iteration) });
  });
  client.addEventListener('busy', (event) => {
    const { busy } = /** @type {CustomEvent} */ (event).detail;
    import('./long-work.js').then(
      ({ offerCancel }) => offerCancel(busy, client),
      () => {},
    );
  });
  on('trouble', ({ message }) => alerts.error(message));
  client.addEventListener('absent', (event) => {
    const { message } = /** @type {CustomEvent} */ (event).detail;
    alerts.stop(message, { label: 'Reload', action: () => location.reload() });
  });
  client.addEventListener('restarted', (event) => {
    const { message } = /** @type {CustomEvent} */ (event).detail;
    alerts.notice(message, offerReport(message, store, alerts));
  });
}
