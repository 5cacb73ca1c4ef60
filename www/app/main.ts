/**
 * Entry point: creates the parts of the page and connects them. The module of words is there first:
 * the page fetches it beside this script. The solver worker and the view module then start
 * concurrently; neither waits for the other.
 */

import { openChosen, acceptDrops } from '../documents/chosen-files.ts';
import { reportCollapse } from '../documents/collapse.tsx';
import { Files } from '../documents/files.ts';
import { measureGoals } from '../features/build/live-build.ts';
import { HoldOriginal } from '../features/hold-original.ts';
import { LAYING_OUT } from '../features/make-panels/layouts.ts';
import { offerPanelCommands } from '../features/make-panels/press.ts';
import { showContextMenu } from '../features/selecting/context-menu.tsx';
import { JobsClient } from '../solver/jobs-client.ts';
import { SolverClient } from '../solver/solver-client.ts';
import { createActions } from '../store/actions.ts';
import { colourFaces } from '../store/colours/colour-scale.ts';
import { colourRows } from '../store/colours/constraint-colours.ts';
import { meshActions } from '../store/mesh-actions.ts';
import { Selecting } from '../store/mesh-queries.ts';
import { runEarlyPresses } from '../store/perform.ts';
import { createStore, withModel } from '../store/state.ts';
import { Alerts } from '../ui/controls/alerts.tsx';
import { closeAboutModel } from '../ui/controls/dialog.ts';
import { tooltips } from '../ui/controls/tooltips.ts';
import { byId } from '../ui/dom.ts';
import { keyInTitle } from '../ui/keys.ts';
import { once } from '../ui/once.ts';
import { showMoved } from '../viewport/input/drag-label.ts';
import { bindViewKeys } from '../viewport/input/gestures.ts';
import { bindHandleKeys } from '../viewport/input/handle-keys.ts';
import { PointerInput } from '../viewport/input/pointer.ts';
import { RegionSelection } from '../viewport/input/region-selection.ts';
import { explainNoPicture } from '../viewport/placeholder.ts';
import { Viewport } from '../viewport/viewport.ts';
import { renderPage } from './app.tsx';
import { followNextStep, followTheme } from './appearance.ts';
import { commandTable } from './command-table.ts';
import { bindButtons, bindKeys, bindRunButton } from './commands.ts';
import { offerReport, reportUncaughtErrors } from './errors.ts';
import { keepFocus } from '../ui/keep-focus.ts';
import { arrangeForWidth } from './layout.ts';
import { stayOffline } from './offline.ts';
import { offerCancel, showLoading } from './progress.ts';
import { scriptApi } from './script-api.ts';
import { Startup } from './startup.ts';
import { followSteps } from './steps.ts';
import type { AppContext } from './context.ts';

const store = createStore();
followTheme(store);
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
  showMenu: (at) => showContextMenu(at),
  doubleClick: (...what) => selecting.doubleClick(...what),
});
bindHandleKeys(viewport, store, actions);
bindViewKeys(viewport);
keepFocus(viewport.element);
colourFaces(store, solver, () => viewport.view);
colourRows(store, solver, actions);

const hold = new HoldOriginal(store, actions);
const startup = new Startup({ store, actions, solver, files, alerts });
const app: AppContext = {
  ...{ store, solver, jobs, viewport, files, actions, selecting, alerts, hold, commands: [] },
  mesh: meshActions(store, solver, actions, alerts),
  works: startup,
  script: scriptApi(store, solver, viewport, files),
};
store.subscribe(['status'], ({ status }) => status && alerts.note(status));
offerPanelCommands(app);
/** Goals on the parts are measured in the second worker, which few scenes need. */
const measureParts = once(() => measureGoals(app));
/** The model for which that was tried: a failure is told once. */
let tried = store.get().model;
store.subscribe(['document'], ({ document: scene, model }) => {
  if (model === tried || !scene?.lesson?.goals.some(({ build }) => build)) return;
  tried = model;
  void actions.reportErrors(measureParts());
});
showMoved(viewport, store);
solver.on('collapsed', ({ collapse }) => reportCollapse(app, collapse));

const fileInput: HTMLInputElement = byId('file');
for (const label of fileInput.labels ?? []) label.title += keyInTitle('Ctrl+O');
fileInput.addEventListener('change', async () => {
  const chosen = [...(fileInput.files ?? [])];
  // Allows the same file to be opened again after it changed on disk.
  fileInput.value = '';
  await actions.reportErrors(files.openings.begin((opening) => openChosen(app, opening, chosen)));
});
acceptDrops(byId('drop-overlay'), app);
files.on('opened', closeAboutModel);

app.commands = commandTable(app, pointer, fileInput);
const { commands } = app;
renderPage(app);
arrangeForWidth();
followSteps(store);
followNextStep(store);
tooltips();
for (const button of document.querySelectorAll('[data-command="reset"]'))
  if (button instanceof HTMLElement) hold.bind(button, { clicks: true });
bindButtons(commands, store);
bindKeys(commands, store, actions.settled);
bindRunButton(byId('run'), store);
/** collected by a script in index.html */
const early: Window & { earlyPresses?: string[] } = window;
runEarlyPresses(commands, store, early.earlyPresses ?? []);
delete early.earlyPresses;
selecting.bindKeys(commands);

viewport.on('none', explainNoPicture);

Object.assign(window, { shapeUp: app.script });

void actions.reportErrors(startup.begin());
const offline = () => stayOffline(alerts, startup, viewport);
viewport.on('ready', offline);
viewport.on('none', offline);

/** Writes the messages of the solver to the store. */
function bindSolver(client: SolverClient) {
  client.on('ready', ({ kinds, measures, operations, settings }) =>
    store.set({ kinds, measures, operations, settings }),
  );
  client.on('model', ({ loaded }) => store.set(withModel(loaded, client)));
  client.on('loading', ({ bytes, all }) => showLoading(store, bytes, all));
  client.on('document', ({ document }) => store.set({ document }));
  client.on('frame', ({ numbers, measure, greatest, answers }) =>
    store.set({
      ...{ numbers, halfway: numbers.halfway },
      greatest: measure === null ? null : { measure, value: greatest },
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
  // The card of new panels says itself what it does, with its own Cancel.
  const isSaid = (job: string) => LAYING_OUT.some((one) => one === job);
  jobs.on('busy', ({ busy, job }) =>
    offerCancel('jobs', busy && !isSaid(job), () => jobs.cancel()),
  );
  client.on('trouble', ({ message }) => alerts.error(message));
  client.on('absent', ({ message }) => {
    alerts.stop(message, { label: 'Reload', action: () => location.reload() });
  });
  client.on('restarted', ({ message }) => {
    alerts.notice(message, offerReport(message, store, alerts));
  });
}
