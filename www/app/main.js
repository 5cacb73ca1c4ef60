/**
 * Entry point: creates the parts of the page and connects them. The solver worker and the view
 * module start concurrently; neither waits for the other.
 */

import { createActions } from '../store/actions.js';
import { Alerts } from '../ui/controls/alerts.js';
import { analysisRegion } from './analysis.js';
import { colourFaces } from '../store/colours/colour-scale.js';
import { commandTable } from './command-table.js';
import { bindButtons, bindKeys, bindRunButton } from './commands.js';
import { byId } from '../ui/dom.js';
import { acceptDrops } from '../documents/opening/drop-zone.js';
import { Files } from '../documents/files.js';
import { ended } from '../ui/format.js';
import { loadFeatures, loadWhenNeeded } from './features.js';
import { firstHints } from '../features/hints.js';
import { arrangeForWidth } from './arrangement/layout.js';
import { messageOf } from '../solver/messages.js';
import { constraintsPanel } from '../panels/constraints/constraints.js';
import { energiesPanel } from '../panels/energies/energies.js';
import { Startup } from './startup.js';
import { handlesPanel } from '../panels/handles/handles.js';
import { bindHalfStepSwitches } from '../store/half-step/half-step.js';
import { HoldOriginal } from '../features/hold-original.js';
import { modelPanel } from '../panels/model/model.js';
import { statusBar } from '../panels/status-bar/status-bar.js';
import { PointerInput } from '../viewport/input/pointer.js';
import { RegionSelection } from '../viewport/input/region-selection.js';
import { colourRows } from '../store/colours/constraint-colours.js';
import { sizeOf } from '../ui/rounding.js';
import { scriptApi } from './script-api.js';
import { Selecting } from '../store/mesh-queries.js';
import { NOTHING } from '../store/selection.js';
import { SolverClient } from '../solver/solver-client.js';
import { splitInto } from '../features/split/split.js';
import { runEarlyPresses } from '../store/press.js';
import { createStore } from '../store/state.js';
import { followAdvanced } from './arrangement/advanced.js';
import { followTheme } from './theme.js';
import { bindViewMenu } from '../features/view-tools/view-commands.js';
import { bindViewKeys } from '../viewport/input/view-keys.js';
import { offerReport, reportUncaughtErrors } from './errors/uncaught-errors.js';
import { Viewport } from '../viewport/viewport.js';

const store = createStore();
followTheme(store);
followAdvanced(store);
const alerts = new Alerts(byId('alert'));
reportUncaughtErrors(alerts, store);
const solver = new SolverClient();
bindSolver(solver);

const actions = createActions(store, solver, alerts);
const viewport = new Viewport(byId('viewport'), store, solver, actions);
const files = new Files(store, solver, alerts, actions);
const region = new RegionSelection(store, viewport, actions);
const selecting = new Selecting(store, solver, actions);
const pointer = new PointerInput(store, solver, viewport, region, actions, {
  addHandles: (vertices) => actions.addHandles(vertices, false),
  selectedHandles: actions.selectedHandles,
  showMenu: (at) =>
    actions.reportErrors(
      import('../features/selecting/context-menu.js').then((it) => it.showContextMenu(at, app)),
    ),
  fitAll: () => viewport.with((view) => view.fit()),
  doubleClick: (...what) => selecting.doubleClick(...what),
});
bindViewKeys(viewport);
const { fit } = colourFaces(store, solver);
colourRows(store, solver, actions);

const hold = new HoldOriginal(store, actions);
/** @type {import("./context.js").AppContext} */
const app = {
  ...{ store, solver, viewport, files, actions, selecting, alerts, hold, commands: [] },
  showSides: (choices) => splitInto(app, choices),
  script: scriptApi(store, solver, viewport, files),
};
viewport.once('ready', showLegend);
modelPanel(byId('model'), app, () => analysis.bring('log'));
constraintsPanel(byId('constraints'), app);
handlesPanel(byId('handles'), app);
energiesPanel(byId('energies'), app);
actions.reportErrors(
  import('../panels/display/display.js').then((it) => it.displayPanel(byId('display'), app)),
);
const analysis = analysisRegion(byId('analysis'), app);
loadWhenNeeded(app, {
  keys: ['example'],
  isNeeded: ({ example }) => example !== null,
  load: () =>
    import('../panels/example/example.js').then((it) =>
      it.exampleNote(byId('example-note'), app, ({ split, plot }) => {
        if (split) app.showSides(split);
        if (plot) analysis.bring(plot);
      }),
    ),
});
store.subscribe(['status'], ({ status }) => status && alerts.note(status));
loadFeatures(app);
loadWhenNeeded(app, {
  keys: ['moved'],
  isNeeded: ({ moved }) => moved !== null,
  load: () => import('../viewport/input/drag-label.js').then((it) => it.showMoved(viewport, store)),
});
solver.on('collapsed', ({ collapse }) =>
  actions.reportErrors(
    import('../documents/collapse.js').then((it) => it.reportCollapse(app, collapse)),
  ),
);
statusBar({ status: byId('status'), hint: byId('hint'), numbers: byId('numbers') }, store);
firstHints(byId('hint-card'), store);
arrangeForWidth(store);

/** @type {HTMLInputElement} */
const fileInput = byId('file');
fileInput.addEventListener('change', async () => {
  const chosen = [...(fileInput.files ?? [])];
  // Allows the same file to be opened again after it changed on disk.
  fileInput.value = '';
  const opened = import('../documents/opening/chosen-files.js').then((it) =>
    it.openChosen(app, chosen),
  );
  await actions.reportErrors(app.files.trackOpening(opened));
});
acceptDrops(byId('drop-overlay'), app);

app.commands = commandTable(app, pointer, fileInput);
const { commands } = app;
for (const button of document.querySelectorAll('[data-command="reset"]'))
  if (button instanceof HTMLElement) hold.bind(button, { clicks: true });
bindButtons(commands, store);
bindKeys(commands, store);
bindRunButton(byId('run'), store);
bindHalfStepSwitches(store);
/** @type {Window & { earlyPresses?: string[] }} collected by a script in index.html */
const early = window;
runEarlyPresses(commands, store, early.earlyPresses ?? []);
delete early.earlyPresses;
bindViewMenu(byId('view-menu'), byId('view-menu-button'), commands, app);
selecting.bindKeys(commands);

viewport.on('none', (why) => {
  actions.reportErrors(import('../viewport/no-picture.js').then((it) => it.explainNoPicture(why)));
});

Object.assign(window, { shapeUp: app.script });

const startup = new Startup(solver, files, alerts, { store, actions, analysis });
byId('recent-button').addEventListener('click', () =>
  actions.reportErrors(
    import('../documents/recent-menu.js').then((it) => it.showRecent(byId('recent'), startup)),
  ),
);
startup.begin().catch((error) => alerts.error(messageOf(error)));
actions.reportErrors(
  import('../documents/examples-menu.js').then((it) => it.examplesMenu(byId('examples'), app)),
);
const offline = () =>
  import('./offline/offline.js').then(
    (it) => it.stayOffline(alerts, startup, viewport),
    () => {},
  );
viewport.on('ready', offline);
viewport.on('none', offline);
actions.reportErrors(import('../ui/controls/tooltips.js').then((it) => it.tooltips()));
actions.reportErrors(
  import('../viewport/input/handle-keys.js').then((it) =>
    it.bindHandleKeys(viewport, store, solver, actions),
  ),
);
actions.reportErrors(import('./arrangement/next-step.js').then((it) => it.followNextStep(store)));
actions.reportErrors(
  import('../panels/status-bar/environment-status.js').then((it) =>
    it.environmentStatus(byId('numbers'), app),
  ),
);

/** Loads and shows the legend. */
function showLegend() {
  const legend = import('../panels/legend/legend.js');
  actions.reportErrors(legend.then(({ legend }) => legend(byId('legend'), app, fit)));
}

/**
 * Writes the messages of the solver to the store.
 * @param {SolverClient} client
 */
function bindSolver(client) {
  client.on('ready', ({ kinds, elements, measures, operations, settings }) =>
    store.set({ kinds, elements, measures, operations, settings }),
  );
  client.on('model', ({ loaded, positions }) =>
    store.set({
      // A restarted worker keeps the view settings.
      ...(!client.restoring && {
        ...{ camera: null, views: [], measureChosen: false },
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
      section: null,
    }),
  );
  client.on('loading', ({ bytes, all }) => {
    // Without it only the progress is not shown.
    import('./progress/solver-loading.js').then(
      ({ showLoading }) => showLoading(store, bytes, all),
      () => {},
    );
  });
  client.on('document', ({ document }) => store.set({ document }));
  client.on('frame', ({ numbers, answers }) =>
    store.set({
      ...{ numbers, halfway: numbers.halfway },
      ...(answers && { dragMs: performance.now() - answers[0] }),
    }),
  );
  client.on('activity', ({ running, converged }) => {
    const before = store.get();
    store.set({ running, converged });
    // A drag that converges keeps the status about its handle.
    if (running === before.running) return;
    const { iteration = 0 } = before.numbers ?? {};
    store.set({ status: running ? 'Running' : ended(converged, iteration) });
  });
  client.on('busy', ({ busy }) => {
    import('./progress/long-work.js').then(
      ({ offerCancel }) => offerCancel(busy, client),
      () => {},
    );
  });
  client.on('trouble', ({ message }) => alerts.error(message));
  client.on('absent', ({ message }) => {
    alerts.stop(message, { label: 'Reload', action: () => location.reload() });
  });
  client.on('restarted', ({ message }) => {
    alerts.notice(message, offerReport(message, store, alerts));
  });
}
