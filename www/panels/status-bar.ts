/** The status bar: status message, hint, numbers of the iteration, and the environment. */

import { RENEW_MS, element, setAttribute, setText, throttled } from '../ui/dom.ts';
import { duration, groupDigits, number } from '../ui/format.ts';
import {
  declared,
  movedInWords,
  toleranceOf,
  valueInWords,
  worstOf,
} from '../store/colours/measures.ts';
import { areHandlesLocked, draggableInWords } from '../store/handles.ts';
import { NEXT_STEP_KEYS, nextStep } from '../store/next-step.ts';
import { energyOrZero } from '../ui/rounding.ts';
import { sizeOfSelection } from '../store/selection.ts';
import { isDrawn, type State } from '../store/state.ts';
import type { AppContext } from '../app/context.ts';
import type { Actions } from '../store/actions.ts';

const RENDERERS = { webgpu: 'WebGPU', webgl2: 'WebGL2', none: 'no 3D', starting: '' };

export function statusBar(
  places: { status: HTMLElement; hint: HTMLElement; numbers: HTMLElement },
  app: AppContext,
) {
  const { store } = app;
  const cells = new Map();
  for (const [key, name, style] of [
    ['iteration', 'iteration', 'narrow-hidden'],
    ['energy', 'energy', 'wide narrow-hidden'],
    ['worst', 'worst panel', 'in-legend'],
    ['moved', 'moved', 'narrow-hidden in-legend'],
    ['step', '', 'narrow-hidden'],
    ['drag', 'drag', 'narrow-hidden'],
    ['units', '', 'wide narrow-hidden'],
    ['saved', '', ''],
    ['renderer', '', 'wide narrow-hidden'],
  ]) {
    const value = element('dd');
    const label = name && element('dt', name);
    const row = element('div', { class: style, hidden: true }, label, value);
    places.numbers.append(row);
    cells.set(key, { row, label, value });
  }
  const set = (key: string, text: string) => {
    const { row, value } = cells.get(key);
    setText(value, text);
    const isEmpty = text === '';
    if (row.hidden !== isEmpty) row.hidden = isEmpty;
  };
  cells.get('drag').row.title = 'Time from a pointer movement to new positions';

  const showNumbers = throttled(RENEW_MS, () => {
    const state = store.get();
    const { numbers, document, model } = state;
    const measure = state.measure ?? document?.measure ?? null;
    if (!numbers) return;
    const units = document?.units ?? '';
    const { timings } = state.display;
    const energy = energyOrZero(numbers.energy.total, model?.size ?? 0);
    set('iteration', timings ? groupDigits(numbers.iteration) : '');
    set('energy', timings ? number(energy) : '');
    const about = declared(state, measure);
    if (about && model?.faces) {
      const worst = worstOf(state, about.id);
      set('worst', valueInWords(about, worst, units, toleranceOf(state, about)));
      // The residual also applies to constraints that are not on panels.
      const what = about.signed ? 'greatest' : 'worst panel';
      setText(cells.get('worst').label, about.id === 'residual' ? 'worst distance' : what);
      setAttribute(cells.get('worst').row, 'title', `${about.label}: ${about.words}`);
    } else {
      set('worst', '');
    }
    set('moved', movedInWords(state));
    set('step', timings && numbers.stepMs > 0 ? `${duration(numbers.stepMs)} per iteration` : '');
  });

  store.subscribe(['status'], ({ status }) => setText(places.status, status));
  store.subscribe(
    ['numbers', 'measure', 'model', 'document', 'tolerances', 'display'],
    showNumbers,
  );
  store.subscribe(['document', 'model'], ({ document, model }) => {
    if (document && model) set('units', `${document.units || 'no unit'} · ${document.up}-up`);
  });
  const showDrag = throttled(RENEW_MS, () => {
    const { dragMs, display } = store.get();
    set('drag', display.timings && dragMs > 0 ? duration(dragMs) : '');
  });
  store.subscribe(['dragMs', 'display'], showDrag);
  store.subscribe(['saved'], ({ saved }) => {
    set('saved', saved);
    // Unsaved changes are shown on screens of any width.
    cells.get('saved').row.className = /^Saved/.test(saved) ? 'wide narrow-hidden' : '';
  });
  store.subscribe(['renderer', 'display'], ({ renderer, display }) =>
    set('renderer', display.timings ? RENDERERS[renderer] : ''),
  );
  store.subscribe(
    [...NEXT_STEP_KEYS, 'tool', 'shape', 'mode', 'selection', 'dragged', 'renderer'],
    (state) => setText(places.hint, hintOf(state)),
  );
  environmentStatus(places.numbers, app);
}

/** Hints for the Select tool, by shape of the drag. */
const SHAPES = { box: 'Drag a box', lasso: 'Draw a lasso', paint: 'Brush' };

/** Returns the hint for the next action. */
function hintOf(state: State) {
  const { model, document, tool, shape, mode, selection, dragged, renderer } = state;
  if (!model || !document) return '';
  if (dragged.length > 0) return 'Release to place it · Esc cancels';
  const next = nextStep(state);
  if (document.constraints.length === 0)
    return next === 'shape'
      ? 'Next: make its panels circular or flat, or add another constraint'
      : 'Next: add a constraint to say what shape its parts should have';
  const isLocked = areHandlesLocked(document);
  if (!isLocked && document.handles.some(({ vertex }) => selection.vertices.has(vertex)))
    return 'Drag the handle, an arrow or a square · Enter, then arrow keys, moves it';
  if (sizeOfSelection(selection) > 0) {
    const makes = isLocked ? '' : 'H turns the selection into handles · ';
    return `${makes}Add constraint can use it · Esc clears the selection`;
  }
  if (renderer === 'none') return 'Run, Export and the panels work without the 3D view';
  if (tool === 'select')
    return `${SHAPES[shape]} over ${mode} · Shift adds, Ctrl removes · V goes back to Drag`;
  if (next === 'choose' && state.verdict)
    return 'Next: see the verdict in the view · drag elsewhere to orbit';
  const { running, converged } = state;
  const one = draggableInWords(document);
  if (!running && !converged)
    return one
      ? `Next: Run, or drag ${one} · drag elsewhere to orbit`
      : 'Next: Run · drag to orbit';
  const build = next === 'build' ? 'Next: Build · ' : '';
  if (isLocked) return `${build}Drag to orbit, wheel to zoom`;
  if (!one) return `${build}Double-click a vertex to drag it · drag elsewhere to orbit`;
  return `Drag ${one} · drag elsewhere to orbit, wheel to zoom`;
}

/** Names of software renderers. */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;
const SLOW = 'Software rendering is slow. Turn on graphics acceleration in the browser settings.';

/**
 * The environment: offline, software rendering.
 * @param numbers the list of the status bar
 */
function environmentStatus(numbers: HTMLElement, { store, actions }: AppContext) {
  const offline = element('div', { hidden: true }, element('dd', 'Offline'));
  const software = element(
    'div.wide.narrow-hidden',
    { title: SLOW, hidden: true },
    element('dd', 'Software rendering'),
  );
  numbers.append(software, offline);
  networkStatus(offline, actions);
  store.subscribe(['renderer'], (state) => {
    software.hidden = !(isDrawn(state) && drawsInSoftware());
  });
}

/** Shows that the browser is offline, while it is. */
function networkStatus(place: HTMLElement, actions: Actions) {
  const update = () => {
    const offline = !navigator.onLine;
    if (offline === !place.hidden) return;
    const kept = Boolean(navigator.serviceWorker?.controller);
    const words = `Offline: ${kept ? 'everything still works' : 'what is loaded still works'}`;
    place.hidden = !offline;
    place.title = words;
    actions.setStatus(offline ? words : 'Online again');
  };
  window.addEventListener('online', update);
  window.addEventListener('offline', update);
  update();
}

/** Whether WebGL is rendered in software. */
function drawsInSoftware() {
  const context = document.createElement('canvas').getContext('webgl2');
  const names = context?.getExtension('WEBGL_debug_renderer_info');
  const name = names && context?.getParameter(names.UNMASKED_RENDERER_WEBGL);
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return SOFTWARE.test(String(name));
}
