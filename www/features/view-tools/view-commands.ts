/**
 * The commands of the view: directions, projection, ghost, ground grid, section plane and measuring
 * tape.
 */

import { ViewHistory } from './view-history.ts';
import { ViewTools } from './view-tools.ts';
import { MOUSE_SETTINGS } from '../../store/state.ts';
import { MOUSE_NAMES } from '../../viewport/input/mouse.ts';
import { stopTurning, turnSlowly } from '../../viewport/camera.ts';
import type { AppContext, Command } from '../../app/context.ts';
import type { State } from '../../store/state.ts';

/** Name of the view, and for some a numpad key; all also have Shift + digit. */
const VIEWS = [
  ['top', 'Numpad7'],
  ['front', 'Numpad1'],
  ['right', 'Numpad3'],
  ['back'],
  ['left'],
  ['bottom'],
  ['isometric', 'Numpad0'],
];

/** Maximum number of kept views. */
const MOST_VIEWS = 9;

export function viewCommands(app: AppContext): Command[] {
  const { store, actions } = app;
  const tools = new ViewTools(app);
  const history = new ViewHistory(app);
  const enabled = ({ renderer }: State) => renderer !== 'none';
  const { element } = app.viewport;

  function keepView() {
    const camera = app.viewport.with((view) => {
      app.viewport.arrive();
      return [...view.camera()];
    });
    if (!camera) return;
    const { parallel, views } = store.get();
    const taken = views.map(({ name }) => Number(name.replace(/\D/g, '')));
    const name = `View ${Math.max(0, ...taken) + 1}`;
    actions.look({ views: [...views, { name, camera, parallel }], status: `${name} is kept` });
  }

  for (const event of ['pointerdown', 'wheel', 'keydown'])
    element.addEventListener(event, () => stopTurning(app.viewport), {
      capture: true,
      passive: true,
    });
  return [
    ...VIEWS.map(([name, ...keys], i) => ({
      id: `view-${name}`,
      group: 'View',
      label: `View: ${name}`,
      keys: [`Shift+${i + 1}`, ...keys],
      action: () => tools.flyTo(name),
      enabled,
    })),
    {
      id: 'camera-back',
      group: 'View',
      label: 'Back to the view before',
      keys: ['Backspace'],
      repeats: true,
      action: () => history.go(-1),
      enabled,
    },
    {
      id: 'camera-forward',
      group: 'View',
      label: 'Forward to the view after',
      keys: ['Shift+Backspace'],
      repeats: true,
      action: () => history.go(1),
      enabled,
    },
    {
      id: 'parallel',
      group: 'View',
      label: 'Parallel or perspective',
      keys: ['5', 'Numpad5'],
      action: () => actions.look({ parallel: !store.get().parallel }),
      enabled,
      pressed: ({ parallel }) => parallel,
    },
    ...['ghost', 'ground'].map((name) => ({
      id: name,
      group: 'View',
      label: name === 'ghost' ? 'Ghost of the original' : 'Ground grid',
      keys: name === 'ghost' ? ['O'] : [],
      action: () => actions.display({ [name]: !store.get().display[name as 'ghost' | 'ground'] }),
      enabled,
      pressed: ({ display }: State) => display[name as 'ghost' | 'ground'],
    })),
    {
      id: 'tape',
      group: 'View',
      label: 'Measure the distance between two vertices',
      keys: ['D'],
      action: () => {
        const { tape, selection } = store.get();
        const chosen = [...selection.vertices];
        actions.look({ tape: tape ? null : chosen.length === 2 ? chosen : [], tool: 'drag' });
      },
      needsModel: true,
      enabled,
      pressed: ({ tape }) => tape !== null,
    },
    {
      id: 'section',
      group: 'View',
      label: 'Section plane',
      keys: [],
      action: () => {
        const section = store.get().section ? null : { axis: 0, at: 0.5, turned: false };
        actions.look({ section });
      },
      needsModel: true,
      enabled,
      pressed: ({ section }) => section !== null,
    },
    {
      id: 'turn-slowly',
      group: 'View',
      label: 'Turn slowly, until the view is touched',
      keys: [],
      action: () => turnSlowly(app.viewport),
      needsModel: true,
      enabled,
    },
    {
      id: 'keep-view',
      group: 'View',
      label: 'Keep this view',
      keys: [],
      action: keepView,
      enabled: (state: State) => enabled(state) && state.views.length < MOST_VIEWS,
    },
    ...MOUSE_SETTINGS.map((mouse) => ({
      id: `mouse-${mouse}`,
      group: 'View',
      label: `Mouse as ${MOUSE_NAMES[mouse]}`,
      keys: [],
      action: () => actions.chooseMouse(mouse),
      pressed: ({ mouse: now }: State) => now === mouse,
    })),
  ];
}
