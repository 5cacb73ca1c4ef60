/** The page about projections: its controls, the state of the iteration, and its display. */

import { byId, element } from '../../ui/dom.ts';
import { number } from '../../ui/words.ts';
import { drawBars, drawPlane } from './drawing.ts';
import { errors, project, reconcile, sum, type Point, type ConstraintSet } from './sets.ts';

document.documentElement.dataset.started = '';

type Bar = { label: string; errors: number[] };

/** Size of the view box, whose origin is at the upper left. */
const SIZE = [100, 60];
const START = [84, 52] as Point;
/** Step of an arrow key; a tenth of it with Shift. */
const KEY_STEP = 2;
const PAUSE_MS = 700;
const MOST_BARS = 12;
/** The point has arrived if a step moves it by less than this. */
const ARRIVED = 1e-4;

const NAMES = ['Line', 'Circle', 'Parabola'];

/** The sets of `meet` all contain (46, 34). */
const CASES: Record<string, ConstraintSet[]> = {
  meet: [
    { kind: 'line', at: [46, 34], turn: -0.45 },
    { kind: 'circle', at: [61, 34], radius: 15 },
    { kind: 'parabola', at: [26, 49], turn: Math.PI, bend: 0.0375 },
  ],
  apart: [
    { kind: 'line', at: [50, 53], turn: -0.1 },
    { kind: 'circle', at: [70, 22], radius: 12 },
    { kind: 'parabola', at: [24, 32], turn: Math.PI + 0.25, bend: 0.05 },
  ],
};

const state = {
  sets: CASES.meet,
  weights: [1, 1, 1],
  x: START,
  /** The projections found in step I; null before it. */
  targets: null as Point[] | null,
  /** Earlier positions of the point. */
  trail: [] as Point[],
  bars: [] as Bar[],
  iteration: 0,
  timer: 0,
  said: '',
};

const still = matchMedia('(prefers-reduced-motion: reduce)');
const drawing = byId<SVGSVGElement>('drawing');
const plane = drawPlane(drawing, NAMES, {
  move: (to) => place(to),
  key: (event) => keyed(event),
});

byId('step').addEventListener('click', () => {
  pause();
  step();
});
byId('play').addEventListener('click', () => (state.timer ? pause() : play()));
byId('back').addEventListener('click', () => place(START));
for (const input of document.querySelectorAll('input[name="case"]')) {
  input.addEventListener('change', () => {
    state.sets = CASES[(input as HTMLInputElement).value];
    plane.showSets(state.sets);
    place(state.x);
  });
}
byId('weights').append(...NAMES.map(weightOf));
byId('rows')
  .parentElement?.querySelector('thead')
  ?.append(element('tr', ...['Half step', ...NAMES, 'φ'].map((name) => element('th', name))));
plane.showSets(state.sets);
place(START);

function weightOf(name: string, i: number) {
  // The slider announces its value itself.
  const value = element('span.weight', { 'aria-hidden': 'true' }, '1');
  const slider = element('input', {
    type: 'range',
    min: '0',
    max: '4',
    step: '0.1',
    value: '1',
    'aria-label': `Weight of the ${name.toLowerCase()}`,
    oninput: () => {
      state.weights[i] = slider.valueAsNumber;
      value.textContent = slider.value;
      place(state.x);
    },
  });
  return element(
    'label',
    element('span', { class: `chip set-${i}` }),
    element('span.name', name),
    slider,
    value,
  );
}

/** Moves the point and restarts the iteration. */
function place(to: Point) {
  pause();
  state.x = to.map((part, axis) => Math.min(Math.max(part, 1), SIZE[axis] - 1)) as Point;
  state.targets = null;
  state.trail = [];
  state.bars = [];
  state.iteration = 0;
  const now = errors(state.x, project(state.sets, state.x), state.weights);
  announce(
    `The point is at proximity φ = ${number(sum(now))}. Step I finds the nearest place on each set.`,
  );
  show(false);
}

/** Takes one half step: I if the projections of the point are not known yet, otherwise II. */
function step() {
  const { sets, weights } = state;
  if (state.targets === null) {
    state.targets = project(sets, state.x);
    state.iteration += 1;
    log(`I, ${state.iteration}`);
    announce(`Step I, iteration ${state.iteration}: the nearest place on each set. ${summary()}`);
  } else {
    const before = state.x;
    const old = errors(before, state.targets, weights);
    state.x = reconcile(before, state.targets, weights);
    state.trail.push(before);
    log(`II, ${state.iteration}`);
    const now = errors(state.x, state.targets, weights);
    const risen = NAMES.filter((_, i) => now[i] > old[i] + 1e-6 * sum(old));
    const but = risen.length
      ? ` The part of the ${risen.join(' and of the ').toLowerCase()} grew, φ did not.`
      : '';
    const arrived = Math.hypot(state.x[0] - before[0], state.x[1] - before[1]) < ARRIVED;
    const end = arrived ? ' The point has arrived.' : '';
    announce(
      `Step II, iteration ${state.iteration}: the point moves to their weighted mean. ${summary()}${but}${end}`,
    );
    if (arrived) pause();
    show(true);
    state.targets = null;
    return;
  }
  show(true);
}

function summary() {
  const parts = errors(state.x, state.targets ?? [], state.weights);
  return `φ = ${number(sum(parts))}.`;
}

function log(label: string) {
  const parts = errors(state.x, state.targets ?? [], state.weights);
  state.bars = [...state.bars, { label, errors: parts }].slice(-MOST_BARS);
}

function play() {
  state.timer = window.setInterval(step, PAUSE_MS);
  byId('play').textContent = 'Pause';
  step();
}

function pause() {
  window.clearInterval(state.timer);
  state.timer = 0;
  byId('play').textContent = 'Play';
}

function announce(text: string) {
  state.said = text;
}

/** @param moves whether the point may glide to its new position */
function show(moves: boolean) {
  byId('explanation').textContent = state.said;
  plane.show(state.x, state.targets, state.trail, moves && !still.matches);
  drawBars(byId<SVGSVGElement>('bars'), state.bars);
  byId('rows').replaceChildren(
    ...state.bars.map(({ label, errors: parts }) =>
      element(
        'tr',
        ...[label, ...parts.map(number), number(sum(parts))].map((text) => element('td', text)),
      ),
    ),
  );
}

function keyed(event: KeyboardEvent) {
  const ways: Record<string, Point> = {
    ArrowLeft: [-1, 0],
    ArrowRight: [1, 0],
    ArrowUp: [0, -1],
    ArrowDown: [0, 1],
  };
  const way = ways[event.key];
  if (!way) return;
  event.preventDefault();
  const far = event.shiftKey ? KEY_STEP / 10 : KEY_STEP;
  place([state.x[0] + far * way[0], state.x[1] + far * way[1]]);
}
