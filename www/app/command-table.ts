/** The table of commands: label, keys, action, and when each is enabled. */

import { exportMesh } from '../documents/exports.ts';
import { openAddConstraint } from '../features/add-constraint/dialog-add-constraint.tsx';
import { showExport } from '../features/export/dialog-export.tsx';
import { flatMaps } from '../features/flat-map/flat-maps.ts';
import { showHelp } from '../features/help/help.tsx';
import { write as writeLesson } from '../features/lesson/dialog.tsx';
import { openRefine } from '../features/make-panels/refine-dialog.tsx';
import { openEdit } from '../features/make-panels/edit-dialog.tsx';
import { newMesh } from '../features/new-mesh/dialog-new-mesh.tsx';
import { PLAN } from '../features/new-mesh/plan.ts';
import { openPalette } from '../features/palette/palette.tsx';
import { openSteps } from '../features/present/steps-dialog.tsx';
import { selectCommands } from '../features/selecting/select-commands.ts';
import { share } from '../features/share/dialog-share.tsx';
import { canVary } from '../features/variations/variations-panel.tsx';
import { viewCommands } from '../features/view-tools/view-commands.ts';
import { halfStepTitle } from '../store/half-step.ts';
import { LOCKED, isLocked, panelsCard } from '../store/panels-card.ts';
import { sizeOfSelection } from '../store/selection.ts';
import { mapInWords } from '../store/stale-map.ts';
import { openPrepared } from '../store/show-dialog.tsx';
import { isDrawn, type State } from '../store/state.ts';
import { byId } from '../ui/dom.ts';
import { isEmbedded } from '../ui/embedded.ts';
import { isTypedInto } from '../ui/keys.ts';
import { inTurn, oneAtATime } from '../ui/once.ts';
import { reveal } from '../ui/reveal.ts';
import { fly } from '../viewport/camera.ts';
import { toggleTheme } from './appearance.ts';
import type { PointerInput } from '../viewport/input/pointer.ts';
import type { AppContext, Command } from './context.ts';

/** Whether the mesh is a surface, and no lesson locks it. */
const canChangeMesh = ({ model, document }: State) =>
  Boolean(document && model?.faces && !model.tets && !isLocked({ document }, 'mesh'));
/** Of a command that changes the mesh: why it is disabled, or else these words. */
const orLocked = (words: string) => (state: State) => (isLocked(state, 'mesh') ? LOCKED : words);

/** The second levels of the steps. */
const LEVELS = [
  ['mesh', 'Show what changes the mesh'],
  ['weights', 'Show weights and solver'],
  ['show', 'Choose what is shown'],
  ['plots', 'Show plots and lists'],
  ['teach', 'Show files, presentation and lesson'],
];

/** Opens the menu of a button, whose step may be closed. */
function openMenuOf(button: HTMLElement) {
  reveal(button);
  button.click();
}

export function commandTable(
  app: AppContext,
  pointer: PointerInput,
  fileInput: HTMLInputElement,
): Command[] {
  const { store, viewport, files, actions, alerts } = app;

  async function fitSelection() {
    await actions.settled();
    const vertices = actions.selectedVertices();
    fly(viewport, (view) =>
      vertices.length > 0 ? view.fitVertices(Uint32Array.from(vertices)) : view.fit(),
    );
  }

  function escape() {
    if (pointer.cancel()) return;
    // Whoever leaves a field by Escape does not mean the selection.
    if (isTypedInto(document.activeElement)) return alerts.clear();
    const newConstraint: HTMLDialogElement = byId('add-constraint');
    if (newConstraint.open) return newConstraint.close();
    if (store.get().tape) return actions.look({ tape: null, status: 'Measuring ended' });
    if (store.get().flatMap) return actions.look({ flatMap: null });
    alerts.clear();
    if (sizeOfSelection(store.get().selection) > 0) return actions.selectNothing();
    if (panelsCard(store.get())) actions.closePanelsCard();
  }

  // Only the solver knows whether there is a step: an edit may have been sent that the page does not
  // show yet. Without one, what is undone is that the model has replaced another one.
  async function undo() {
    if ((await actions.undo()) === null) await files.goBack();
  }

  async function redo() {
    if ((await actions.redo()) === null) await files.goForward();
  }

  /** Docks a panel, or closes it if it is docked. */
  const docks = (panel: NonNullable<State['docked']>) => () =>
    actions.look({ docked: store.get().docked === panel ? null : panel });

  /**
   * Opens something: a press while that or another is being prepared has no effect, as two dialogs
   * would open. Errors are shown.
   */
  const opens = (open: () => unknown) => () => actions.reportErrors(prepare(open));
  const prepare = oneAtATime((open: () => unknown) => openPrepared(app, open));
  /**
   * Opens something once what is being opened now is open, as a question about that may take long:
   * until then others can be opened.
   */
  const opensLater = (open: () => unknown) => {
    const begin = oneAtATime(async () => {
      await files.untilOpen();
      await prepare(open);
    });
    return () => actions.reportErrors(begin());
  };
  /** Opens and closes something: a second press meanwhile closes what the first one opens. */
  const toggles = (toggle: () => unknown) => {
    const begin = inTurn(toggle);
    return () => actions.reportErrors(begin());
  };

  return [
    {
      id: 'run',
      group: 'Solver',
      label: 'Run or pause',
      keys: [' '],
      action: actions.runOrPause,
      needsModel: true,
      title: ({ running }) =>
        running
          ? 'Pause the iteration'
          : 'Move the mesh until the constraints are satisfied as well as the weights allow',
    },
    {
      id: 'step',
      group: 'Solver',
      label: 'Step: one iteration',
      keys: ['.'],
      repeats: true,
      action: actions.step,
      needsModel: true,
    },
    {
      id: 'half-step',
      group: 'Solver',
      label: 'Half step: the local step, then the global step',
      keys: [','],
      repeats: true,
      action: actions.halfStep,
      needsModel: true,
      // It ends a drag, and the moves after it would be lost.
      enabled: ({ dragged }) => dragged.length === 0,
      title: halfStepTitle,
    },
    {
      id: 'reset',
      group: 'Solver',
      label: 'Reset: back to the original',
      keys: ['Shift+R'],
      action: actions.reset,
      needsModel: true,
      title: () => 'Back to the original; hold to see it',
    },
    {
      id: 'hold-original',
      group: 'View',
      label: 'Hold: show the original',
      keys: ['R'],
      unlisted: true,
      action: () => app.hold.begin(),
      enabled: (state) => state.document !== null && isDrawn(state),
    },
    {
      id: 'show-original',
      group: 'View',
      label: 'Show the original until the next press',
      keys: [],
      action: () => app.hold.showUntilPress(),
      enabled: (state) => state.document !== null && isDrawn(state),
    },
    {
      id: 'undo',
      group: 'Edit',
      label: 'Undo',
      keys: ['Ctrl+Z'],
      repeats: true,
      action: undo,
      enabled: ({ document, dragged, undoReplacing }) =>
        Boolean(document?.undo || undoReplacing) && dragged.length === 0,
      title: ({ document, undoReplacing }) => {
        const what = document?.undo || undoReplacing;
        return what ? `Undo: ${what}` : 'Nothing to undo';
      },
    },
    {
      id: 'redo',
      group: 'Edit',
      label: 'Redo',
      keys: ['Ctrl+Shift+Z', 'Ctrl+Y'],
      repeats: true,
      action: redo,
      enabled: ({ document, dragged, redoReplacing }) =>
        Boolean(document?.redo || redoReplacing) && dragged.length === 0,
      title: ({ document, redoReplacing }) => {
        const what = document?.redo || redoReplacing;
        return what ? `Redo: ${what}` : 'Nothing to redo';
      },
    },
    {
      id: 'add-handles',
      group: 'Edit',
      label: 'Turn the selected vertices into handles',
      keys: ['H'],
      action: () => actions.holdSelected(false),
      needsModel: true,
    },
    {
      id: 'remove-handles',
      group: 'Edit',
      label: 'Remove the selected handles',
      keys: ['Shift+H', 'Delete'],
      action: () => actions.releaseSelected(),
      needsModel: true,
    },
    {
      id: 'next-handle',
      group: 'Edit',
      label: 'Select the next handle',
      keys: ['G'],
      repeats: true,
      action: () => actions.selectNextHandle(),
      needsModel: true,
    },
    {
      id: 'tool-drag',
      group: 'Tools',
      label: 'Drag handles and orbit',
      keys: ['V'],
      action: () => actions.look({ tool: 'drag' }),
      pressed: ({ tool }) => tool === 'drag',
    },
    {
      id: 'tool-select',
      group: 'Tools',
      label: 'Select with a box, a lasso or a brush',
      keys: [],
      action: () => actions.look({ tool: 'select' }),
      pressed: ({ tool }) => tool === 'select',
    },
    {
      id: 'mode-vertices',
      group: 'Tools',
      label: 'Select vertices',
      keys: ['1'],
      action: () => actions.look({ mode: 'vertices' }),
      pressed: ({ mode }) => mode === 'vertices',
    },
    {
      id: 'mode-edges',
      group: 'Tools',
      label: 'Select edges',
      keys: ['2'],
      action: () => actions.look({ mode: 'edges' }),
      pressed: ({ mode }) => mode === 'edges',
    },
    {
      id: 'mode-faces',
      group: 'Tools',
      label: 'Select faces',
      keys: ['3'],
      action: () => actions.look({ mode: 'faces' }),
      pressed: ({ mode }) => mode === 'faces',
    },
    {
      id: 'nothing',
      group: 'Tools',
      label: 'Cancel a drag, close a card, or clear the selection',
      keys: ['Escape'],
      unlisted: true,
      action: escape,
    },
    {
      id: 'fit-selection',
      group: 'View',
      label: 'Fit the selection',
      keys: ['F'],
      action: fitSelection,
      enabled: isDrawn,
    },
    {
      id: 'fit-all',
      group: 'View',
      label: 'Fit all',
      keys: ['Home'],
      action: () =>
        fly(viewport, (view) => {
          view.fit();
          view.fitMap();
        }),
      enabled: isDrawn,
    },
    {
      id: 'edges',
      group: 'View',
      label: 'Show or hide edges',
      keys: ['W'],
      action: () => actions.display({ edges: !store.get().display.edges }),
    },
    {
      id: 'add-constraint',
      group: 'Edit',
      label: 'Add constraint',
      keys: [],
      action: () => openAddConstraint(app),
      needsModel: true,
      enabled: (state) => !isLocked(state, 'constraints'),
    },
    {
      id: 'build',
      group: 'File',
      label: 'Build: parts on sheets',
      keys: [],
      action: docks('parts'),
      needsModel: true,
      pressed: ({ docked }) => docked === 'parts',
    },
    {
      id: 'curvature',
      group: 'View',
      label: 'Curvature',
      keys: [],
      action: () =>
        actions.look({ corner: store.get().corner === 'curvature' ? null : 'curvature' }),
      needsModel: true,
      enabled: ({ model, renderer }) => Boolean(model?.faces) && renderer !== 'none',
    },
    {
      id: 'export-as',
      group: 'File',
      label: 'More formats: Rhino, tables, pictures',
      keys: ['Ctrl+Shift+E'],
      action: opens(() => showExport(app)),
      needsModel: true,
    },
    {
      id: 'parametrize',
      group: 'View',
      label: 'Flatten: a flat map beside the model',
      keys: ['U'],
      action: toggles(() => flatMaps(app).toggle()),
      needsModel: true,
      enabled: ({ model }) => Boolean(model?.faces),
      pressed: (state) => state.flatMap !== null,
    },
    {
      id: 'help',
      group: 'Page',
      label: 'Help: mouse, keys, files',
      keys: ['?', 'F1'],
      action: () => showHelp(app),
      title: () => 'Mouse and keys',
    },
    {
      id: 'lesson',
      group: 'File',
      label: 'Write a lesson: a text, and goals that are checked',
      keys: [],
      action: opens(() => writeLesson(app)),
      needsModel: true,
    },
    {
      id: 'edit-mesh',
      group: 'Edit',
      label: 'Edit mesh',
      keys: [],
      enabled: canChangeMesh,
      action: opens(() => openEdit(app)),
      title: orLocked(''),
    },
    {
      id: 'refine',
      group: 'Edit',
      label: 'Refine',
      keys: [],
      enabled: canChangeMesh,
      action: opens(() => openRefine(app)),
      title: orLocked(''),
    },
    {
      id: 'new-panels',
      group: 'Edit',
      label: 'New panels along the lines of curvature',
      keys: [],
      enabled: canChangeMesh,
      action: () => actions.look({ corner: 'new-panels' }),
      title: orLocked('Lays out panels along the lines of curvature'),
    },
    {
      id: 'variations',
      group: 'Edit',
      label: 'Variations: other shapes that are as exact as this one',
      keys: [],
      needsModel: true,
      enabled: canVary,
      title: (state) => {
        if (canVary(state)) return 'Other shapes that are as exact as this one';
        return state.model?.faces === 0
          ? 'For models with faces'
          : 'Available once all required constraints are satisfied';
      },
      action: docks('variations'),
    },
    {
      id: 'new-mesh',
      group: 'File',
      label: 'New mesh',
      keys: [],
      // What is being opened is what comes back after the trials.
      action: opensLater(() => newMesh(app)),
    },
    {
      id: 'draw',
      group: 'File',
      label: 'New mesh from a drawn plan',
      keys: [],
      action: opensLater(() => newMesh(app, PLAN)),
    },
    {
      id: 'present',
      group: 'View',
      label: 'Present: a full-screen sequence of views',
      keys: [],
      needsModel: true,
      action: opens(() => openSteps(app)),
    },
    ...selectCommands(app),
    {
      id: 'share',
      group: 'File',
      label: 'Share a link to the scene',
      keys: [],
      action: opens(() => share(app)),
      needsModel: true,
    },
    ...viewCommands(app),
    {
      id: 'open',
      group: 'File',
      label: 'Open file',
      keys: ['Ctrl+O'],
      action: () => fileInput.click(),
    },
    ...['Examples', 'Open recent'].map((label, i) => ({
      id: ['examples', 'recent'][i],
      group: 'File',
      label,
      keys: [],
      action: () => openMenuOf(byId(['examples-button', 'recent-button'][i])),
    })),
    {
      id: 'save',
      group: 'File',
      label: 'Save scene',
      keys: ['Ctrl+S'],
      action: () => files.saveScene(),
      needsModel: true,
      title: () => 'Save the mesh with its constraints, handles and weights',
    },
    {
      id: 'export',
      group: 'File',
      label: 'Export the shape as OBJ',
      keys: ['Ctrl+E'],
      action: () => actions.reportErrors(exportMesh(app)),
      needsModel: true,
      title: (state) => {
        const mapped = mapInWords(app, state);
        return `Save the current shape${mapped ? `, ${mapped},` : ''} as OBJ`;
      },
    },
    {
      id: 'palette',
      group: 'Page',
      label: 'All commands by name',
      keys: ['Ctrl+K'],
      unlisted: true,
      // Another page has no steps that a command could show.
      action: () => !isEmbedded && openPalette(app),
    },
    ...LEVELS.map(([id, label]) => ({
      id: `show-${id}`,
      group: 'Page',
      label,
      keys: [],
      action: () => reveal(byId(`level-${id}`)),
    })),
    {
      id: 'theme',
      group: 'Page',
      label: 'Light or dark',
      keys: [],
      action: () => toggleTheme(store),
    },
  ];
}
