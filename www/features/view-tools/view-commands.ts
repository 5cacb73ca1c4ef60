/**
 * The commands of the view: directions, projection, ghost, ground grid, section plane and measuring
 * tape.
 */

import { ViewHistory } from './view-history.ts';
import { ViewTools } from './view-tools.ts';
import type { AppContext, Command } from '../../app/context.ts';
import type { State } from '../../store/state.ts';
import type { Viewport } from '../../viewport/viewport.ts';

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

export function viewCommands(app: AppContext): Command[] {
  const { store, actions } = app;
  const tools = new ViewTools(app);
  const history = new ViewHistory(app);
  const enabled = ({ renderer }: State) => renderer !== 'none';
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
  ];
}

/** Seconds per turn of the turntable. */
const TURN = 24;
/** What ends turning. */
const EVENTS = ['pointerdown', 'wheel', 'keydown'] as const;

/** Stops the current turning. */
let end: (() => void) | null = null;

/** Turns the model slowly, as on a turntable, until the user touches the view; or stops that. */
function turnSlowly(viewport: Viewport) {
  if (end) return end();
  let last = performance.now();
  let request = requestAnimationFrame(turn);
  const listening = new AbortController();
  end = () => {
    cancelAnimationFrame(request);
    listening.abort();
    end = null;
  };
  for (const event of EVENTS)
    viewport.element.addEventListener(event, end, {
      capture: true,
      passive: true,
      signal: listening.signal,
    });

  function turn(now: number) {
    // A page that was hidden continues from the same angle.
    const passed = Math.min(Math.max(now - last, 0), 100);
    last = now;
    viewport.unmeasured((view) => view.spin((2 * Math.PI * passed) / 1000 / TURN));
    request = requestAnimationFrame(turn);
  }
}
