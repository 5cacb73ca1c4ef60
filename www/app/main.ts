/**
 * Entry point: creates the parts of the page and connects them. The solver worker and the view
 * module start concurrently; neither waits for the other.
 */

import { createActions } from '../store/actions.ts';
import { Alerts } from '../ui/controls/alerts.ts';
import { analysisRegion } from './analysis.ts';
import { colourFaces } from '../store/colours/colour-scale.ts';
import { commandTable } from './command-table.ts';
import { bindButtons, bindKeys, bindRunButton } from './commands.ts';
import { byId } from '../ui/dom.ts';
import { acceptDrops } from '../documents/opening/drop-zone.ts';
import { Files } from '../documents/files.ts';
import { loadFeatures, loadWhenNeeded } from './features.ts';
import { firstHints } from '../features/hints.ts';
import { arrangeForWidth } from './arrangement/layout.ts';
import { messageOf } from '../solver/errors.ts';
import { constraintsPanel } from '../panels/constraints/constraints.ts';
import { energiesPanel } from '../panels/energies/energies.ts';
import { Startup } from './startup.ts';
import { handlesPanel } from '../panels/handles/handles.ts';
import { bindHalfStepSwitches } from '../store/half-step/half-step.ts';
import { HoldOriginal } from '../features/hold-original.ts';
import { modelPanel } from '../panels/model/model.ts';
import { statusBar } from '../panels/status-bar/status-bar.ts';
import { PointerInput } from '../viewport/input/pointer.ts';
import { RegionSelection } from '../viewport/input/region-selection.ts';
import { colourRows } from '../store/colours/constraint-colours.ts';
import { sizeOf } from '../ui/rounding.ts';
import { scriptApi } from './script-api.ts';
import { Selecting } from '../store/mesh-queries.ts';
import { NOTHING } from '../store/selection.ts';
import { JobsClient } from '../solver/jobs-client.ts';
import { SolverClient } from '../solver/solver-client.ts';
import { runEarlyPresses } from '../store/press.ts';
import { createStore } from '../store/state.ts';
import { followAdvanced } from './arrangement/advanced.ts';
import { followTheme } from './theme.ts';
import { bindViewMenu } from '../features/view-tools/view-commands.ts';
import { bindViewKeys } from '../viewport/input/view-keys.ts';
import { offerReport, reportUncaughtErrors } from './errors/uncaught-errors.ts';
import { Viewport } from '../viewport/viewport.ts';
import type { AppContext } from './context.ts';

const store = createStore();
followTheme(store);
followAdvanced(store);
const alerts = new Alerts(byId('alert'));
reportUncaughtErrors(alerts, store);
const solver = new SolverClient();
const jobs = new JobsClient(solver.module);
bindSolver(solver);

const actions = createActions(store, solver, jobs, alerts);
const viewport = new Viewport(byId('viewport'), store, solver, actions);
const files = new Files(store, solver, alerts, actions);
const region = new RegionSelection(store, viewport, actions);
const selecting = new Selecting(store, solver, actions);
const pointer = new PointerInput(store, solver, viewport, region, actions, {
  addHandles: (vertices) => actions.addHandles(vertices, false),
  selectedHandles: actions.selectedHandles,
  showMenu: (at) =>
    actions.reportErrors(
      import('../features/selecting/context-menu.ts').then((it) => it.showContextMenu(at, app)),
    ),
  fitAll: () => viewport.with((view) => view.fit()),
  doubleClick: (...what) => selecting.doubleClick(...what),
});
bindViewKeys(viewport);
const { fit } = colourFaces(store, solver);
colourRows(store, solver, actions);

const hold = new HoldOriginal(store, actions);
const app: AppContext = {
  ...{ store, solver, jobs, viewport, files, actions, selecting, alerts, hold, commands: [] },
  script: scriptApi(store, solver, viewport, files),
};
viewport.once('ready', showLegend);
modelPanel(byId('model'), app, () => analysis.bring('log'));
constraintsPanel(byId('constraints'), app);
handlesPanel(byId('handles'), app);
energiesPanel(byId('energies'), app);
void actions.reportErrors(
  import('../panels/display/display.ts').then((it) => it.displayPanel(byId('display'), app)),
);
const analysis = analysisRegion(byId('analysis'), app);
loadWhenNeeded(app, {
  keys: ['example'],
  isNeeded: ({ example }) => example !== null,
  load: () =>
    import('../panels/example/example.ts').then((it) =>
      it.exampleNote(byId('example-note'), app, (plot) => analysis.bring(plot)),
    ),
});
store.subscribe(['status'], ({ status }) => status && alerts.note(status));
loadFeatures(app);
loadWhenNeeded(app, {
  keys: ['moved'],
  isNeeded: ({ moved }) => moved !== null,
  load: () => import('../viewport/input/drag-label.ts').then((it) => it.showMoved(viewport, store)),
});
solver.on('collapsed', ({ collapse }) =>
  actions.reportErrors(
    import('../documents/collapse.ts').then((it) => it.reportCollapse(app, collapse)),
  ),
);
statusBar({ status: byId('status'), hint: byId('hint'), numbers: byId('numbers') }, store);
firstHints(byId('hint-card'), store);
arrangeForWidth(store);

const fileInput: HTMLInputElement = byId('file');
fileInput.addEventListener('change', async () => {
  const chosen = [...(fileInput.files ?? [])];
  // Allows the same file to be opened again after it changed on disk.
  fileInput.value = '';
  const opened = files.openings.begin(async (opening) => {
    const { openChosen } = await import('../documents/opening/chosen-files.ts');
    await openChosen(app, opening, chosen);
  });
  await actions.reportErrors(opened);
});
acceptDrops(byId('drop-overlay'), app);

app.commands = commandTable(app, pointer, fileInput);
const { commands } = app;
for (const button of document.querySelectorAll('[data-command="reset"]'))
  if (button instanceof HTMLElement) hold.bind(button, { clicks: true });
bindButtons(commands, store);
bindKeys(commands, store, actions.settled);
bindRunButton(byId('run'), store);
bindHalfStepSwitches(store);
/** collected by a script in index.html */
const early: Window & { earlyPresses?: string[] } = window;
runEarlyPresses(commands, store, early.earlyPresses ?? []);
delete early.earlyPresses;
bindViewMenu(byId('view-menu'), byId('view-menu-button'), commands, app);
selecting.bindKeys(commands);

viewport.on('none', (why) => {
  void actions.reportErrors(
    import('../viewport/no-picture.ts').then((it) => it.explainNoPicture(why)),
  );
});

Object.assign(window, { shapeUp: app.script });

const startup = new Startup(solver, files, alerts, { store, actions, analysis });
byId('recent-button').addEventListener('click', () =>
  actions.reportErrors(
    import('../documents/recent-menu.ts').then((it) => it.showRecent(byId('recent'), startup)),
  ),
);
startup.begin().catch((error) => alerts.error(messageOf(error)));
void actions.reportErrors(
  import('../documents/examples-menu.ts').then((it) => it.examplesMenu(byId('examples'), app)),
);
const offline = () =>
  import('./offline/offline.ts').then(
    (it) => it.stayOffline(alerts, startup, viewport),
    () => {},
  );
viewport.on('ready', offline);
viewport.on('none', offline);
void actions.reportErrors(import('../ui/controls/tooltips.ts').then((it) => it.tooltips()));
void actions.reportErrors(
  import('../viewport/input/handle-keys.ts').then((it) =>
    it.bindHandleKeys(viewport, store, solver, actions),
  ),
);
void actions.reportErrors(
  import('./arrangement/next-step.ts').then((it) => it.followNextStep(store)),
);
void actions.reportErrors(
  import('../panels/status-bar/environment-status.ts').then((it) =>
    it.environmentStatus(byId('numbers'), app),
  ),
);

/** Loads and shows the legend. */
function showLegend() {
  const legend = import('../panels/legend/legend.ts');
  void actions.reportErrors(legend.then(({ legend }) => legend(byId('legend'), app, fit)));
}

/** Offers to cancel what takes long. */
function offerCancel(worker: string, busy: boolean, cancel: () => void) {
  import('./progress/long-work.ts').then(
    (it) => it.offerCancel(worker, busy, cancel),
    () => {},
  );
}

/** Writes the messages of the solver to the store. */
function bindSolver(client: SolverClient) {
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
    import('./progress/solver-loading.ts').then(
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
    const ended = before.numbers?.ended[converged ? 'converged' : 'paused'];
    store.set({ status: running ? 'Running' : (ended ?? '') });
  });
  client.on('busy', ({ busy }) => offerCancel('solver', busy, () => client.abandon()));
  jobs.on('busy', ({ busy }) => offerCancel('jobs', busy, () => jobs.cancel()));
  client.on('trouble', ({ message }) => alerts.error(message));
  client.on('absent', ({ message }) => {
    alerts.stop(message, { label: 'Reload', action: () => location.reload() });
  });
  client.on('restarted', ({ message }) => {
    alerts.notice(message, offerReport(message, store, alerts));
  });
}
