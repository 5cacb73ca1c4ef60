/** The table of commands: label, keys, action, and when each is enabled. */

import { byId } from '../ui/dom.ts';
import { halfStepTitle } from '../store/half-step/half-step.ts';
import { featureCommands } from './features.ts';
import { isDrawn } from '../store/state.ts';
import { fly } from '../viewport/flight.ts';
import { toggleTheme } from './theme.ts';
import type { AppContext, Command } from './context.ts';
import type { PointerInput } from '../viewport/input/pointer.ts';

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
    const newConstraint: HTMLDialogElement = byId('add-constraint');
    if (newConstraint.open) return newConstraint.close();
    if (store.get().tape) return store.set({ tape: null, status: 'Measuring ended' });
    if (store.get().flatMap) return store.set({ flatMap: null });
    alerts.clear();
    actions.selectNothing();
  }

  return [
    {
      id: 'run',
      group: 'Solver',
      label: 'Run or pause',
      keys: [' '],
      action: actions.runOrPause,
      needsModel: true,
      title: ({ running }) => (running ? 'Pause the iteration' : 'Iterate until nothing changes'),
    },
    {
      id: 'step',
      group: 'Solver',
      label: 'One iteration',
      keys: ['.'],
      action: actions.step,
      needsModel: true,
    },
    {
      id: 'half-step',
      group: 'Solver',
      label: 'Half an iteration: the local step, then the global step',
      keys: [','],
      action: actions.halfStep,
      needsModel: true,
      title: halfStepTitle,
    },
    {
      id: 'reset',
      group: 'Solver',
      label: 'Back to the original',
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
      action: () => app.hold.begin(),
      enabled: (state) => state.document !== null && isDrawn(state),
    },
    {
      id: 'undo',
      group: 'Edit',
      label: 'Undo',
      keys: ['Ctrl+Z'],
      action: () => (store.get().document?.undo ? actions.undo() : files.goBack()),
      enabled: ({ document, dragged, isNew }) =>
        Boolean(document?.undo || isNew) && dragged.length === 0,
      title: ({ document, isNew }) => {
        const what = document?.undo || (isNew && 'New mesh');
        return what ? `Undo: ${what}` : 'Nothing to undo';
      },
    },
    {
      id: 'redo',
      group: 'Edit',
      label: 'Redo',
      keys: ['Ctrl+Shift+Z', 'Ctrl+Y'],
      action: actions.redo,
      enabled: ({ document, dragged }) => Boolean(document?.redo) && dragged.length === 0,
      title: ({ document }) => (document?.redo ? `Redo: ${document.redo}` : 'Nothing to redo'),
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
      action: () => actions.selectNextHandle(),
      needsModel: true,
    },
    {
      id: 'tool-drag',
      group: 'Tools',
      label: 'Drag handles and orbit',
      keys: ['V'],
      action: () => store.set({ tool: 'drag' }),
      pressed: ({ tool }) => tool === 'drag',
    },
    {
      id: 'tool-select',
      group: 'Tools',
      label: 'Select with a box, a lasso or a brush',
      keys: [],
      action: () => store.set({ tool: 'select' }),
      pressed: ({ tool }) => tool === 'select',
    },
    {
      id: 'mode-vertices',
      group: 'Tools',
      label: 'Select vertices',
      keys: ['1'],
      action: () => store.set({ mode: 'vertices' }),
      pressed: ({ mode }) => mode === 'vertices',
    },
    {
      id: 'mode-edges',
      group: 'Tools',
      label: 'Select edges',
      keys: ['2'],
      action: () => store.set({ mode: 'edges' }),
      pressed: ({ mode }) => mode === 'edges',
    },
    {
      id: 'mode-faces',
      group: 'Tools',
      label: 'Select faces',
      keys: ['3'],
      action: () => store.set({ mode: 'faces' }),
      pressed: ({ mode }) => mode === 'faces',
    },
    {
      id: 'nothing',
      group: 'Tools',
      label: 'Cancel a drag, close a panel, or clear the selection',
      keys: ['Escape'],
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
      action: () => {
        const { display } = store.get();
        store.set({ display: { ...display, edges: !display.edges } });
      },
    },
    ...featureCommands(app),
    {
      id: 'open',
      group: 'File',
      label: 'Open file',
      keys: ['Ctrl+O'],
      action: () => fileInput.click(),
    },
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
      action: () => files.exportMesh(),
      needsModel: true,
      title: ({ flatMap }) =>
        `Save the current shape${flatMap ? ', with its flat map,' : ''} as OBJ`,
    },
    {
      id: 'advanced',
      group: 'Page',
      label: 'Show all controls or only the essentials',
      keys: [],
      action: () => store.set({ advanced: !store.get().advanced }),
      pressed: ({ advanced }) => advanced,
    },
    {
      id: 'theme',
      group: 'Page',
      label: 'Light or dark',
      keys: [],
      action: () => toggleTheme(store),
    },
  ];
}
