/**
 * The card of new panels: they are laid out along the lines of curvature in the second worker, drawn
 * over the mesh, and taken in its place.
 */

import './new-panels.css';
import { amountField, button, checkbox, choice, closeButton } from '../../ui/controls/fields.ts';
import { element, setText } from '../../ui/dom.ts';
import { once } from '../../ui/once.ts';
import { Cancelled, messageOf } from '../../solver/errors.ts';
import { groupDigits } from '../../ui/format.ts';
import { latestOnly } from '../../store/latest-only.ts';
import { cover, fly, narrow } from '../../viewport/camera.ts';
import { boundaryForecasts, paragraphs } from './layout-words.ts';
import type { AppContext } from '../../app/context.ts';
import type { KindInfo } from '../../solver/types.ts';
import type {
  BoundaryForecast,
  LaidOut,
  LayoutNote,
  LayoutSettings,
  RefusedAt,
} from '../../pkg/engine/shape_up.js';

const theCard = once(newPanelsCard);

/**
 * Opens the card.
 * @param make makes all panels one shape
 */
export const openNewPanels = (app: AppContext, make: (kind: KindInfo) => unknown) =>
  theCard(app, make).open();

/** Initial positions of the sliders, from 0 to 1. */
const FOLLOW = 2 / 3;
const EVEN = 0.25;
/** Time without another wish after which both choices at the boundary are forecast. */
const IDLE_MS = 1000;
/** The choices at the boundary, with the labels of their options and of their forecasts. */
const BOUNDARIES: [BoundaryForecast['boundary'], string, string][] = [
  ['follow', 'Followed by the panels', 'Followed'],
  ['cut', 'Cuts the panels', 'Cut'],
];
/** Followed, unless cut panels move half as far or less. */
const AUTOMATIC = 'Automatic';

function newPanelsCard(
  { store, solver, jobs, viewport, actions, alerts }: AppContext,
  make: (kind: KindInfo) => unknown,
) {
  /** The panels that are shown, what they were asked for, the generations of the model and of the shape. */
  let laidOut: {
    panels: LaidOut;
    asked: LayoutSettings;
    generation: number;
    shape: number | undefined;
  } | null = null;
  /** The layout under way. */
  let laying: Promise<unknown> = Promise.resolve();
  /** The model that the card is about. */
  let about: unknown = null;
  /** Whether the edges of the mesh were hidden for the drawing. */
  let hidesEdges = false;
  /** The place of a refusal. */
  let refused: RefusedAt | null = null;
  /** Both choices at the boundary, once they are known, and whether they are being forecast. */
  let forecast: BoundaryForecast[] | null = null;
  let isForecasting = false;
  /** The number of layouts that were begun. */
  let turn = 0;
  /** The faces that were selected when the card was opened. */
  let selected: Uint32Array<ArrayBuffer> = new Uint32Array(0);
  /** The fields that the user has set. */
  let wished: Pick<LayoutSettings, 'count' | 'size' | 'boundary'> = {};

  const count = amountField('Panels', (count) => wish({ count: count || null, size: null }), {
    step: '1',
  });
  const size = amountField('Side', (size) => wish({ size: size || null, count: null }));
  const unit = element('span.unit');
  const follow = slider('Fewer irregular points', 'Smaller move', FOLLOW);
  const even = slider('Sizes as the curvature asks', 'Even sizes', EVEN);
  const boundary = choice({}, chooseBoundary, [
    ['', AUTOMATIC],
    ...BOUNDARIES.map(([value, label]) => [value, label]),
  ]);
  const forecasts = element('dl.quiet');
  const boundaryLine = element(
    'div.boundary',
    element('label', element('span', 'Boundary'), boundary),
    forecasts,
  );
  const keeps = checkbox('', update);
  const keepsWords = element('span');
  keeps.label.append(keepsWords);
  const then = choice({}, () => {});
  const said = element('div.said', { 'aria-live': 'polite' });
  const doing = element('span');
  const working = element(
    'div.working',
    { hidden: true },
    element('progress', { 'aria-label': 'Laying out panels' }),
    doing,
    button('Cancel', () => jobs.cancel()),
  );
  const take = button('Use these panels', use, { class: 'primary' });
  const closing = closeButton('Close new panels', close);
  const card = element(
    'section.card',
    { id: 'new-panels', 'aria-labelledby': 'heading-new-panels', hidden: true },
    element('div.title', element('h2', { id: 'heading-new-panels' }, 'New panels'), closing),
    element(
      'div.sizes',
      element('label', element('span', 'Panels'), count.field),
      element('label', element('span', 'Side'), size.field, unit),
    ),
    follow.place,
    even.place,
    boundaryLine,
    keeps.label,
    said,
    working,
    element('div.last', element('label', element('span', 'Then'), then), take),
  );
  viewport.element.after(card);

  function wish(wishes: typeof wished) {
    wished = { ...wished, ...wishes };
    update();
  }

  function slider(low: string, high: string, value: number) {
    const field = element('input', {
      ...{ type: 'range', min: '0', max: '1', step: 'any', value: String(value) },
      'aria-label': `${low} to ${high.toLowerCase()}`,
      oninput: update,
    });
    const ends = element('div.ends', element('span', low), element('span', high));
    return { field, place: element('div.slider', field, ends) };
  }

  const layouts = latestOnly(layOut);

  function update() {
    forecast = null;
    if (layouts.isBusy()) void layouts.ask();
    else laying = layouts.ask();
  }

  function chooseBoundary(value: string) {
    wished.boundary = BOUNDARIES.find(([boundary]) => boundary === value)?.[0] ?? null;
    if (layouts.isBusy()) void layouts.ask();
    else laying = layouts.ask();
  }

  async function layOut() {
    const model = solver.copy();
    if (card.hidden || !model) return;
    turn += 1;
    const shape = solver.geometry?.generation;
    work('Laying out panels …');
    const settings: LayoutSettings = {
      ...wished,
      follow: follow.field.valueAsNumber,
      even: even.field.valueAsNumber,
    };
    const kept = keeps.box.checked ? selected : new Uint32Array(0);
    try {
      const panels = await jobs.copy(model).layOutPanels(settings, kept);
      // Another wish, or another shape, has come meanwhile.
      if (card.hidden || layouts.hasNext()) return;
      laidOut = { panels, asked: settings, generation: model.generation, shape };
      refused = null;
      show(panels);
      if (panels.boundary) void foretell(() => jobs.copy(model).panelsAtBoundaries(settings, kept));
    } catch (error) {
      if (card.hidden) return;
      if (error instanceof Cancelled) return laidOut ? goBack(laidOut) : close();
      refused = (await jobs.ask.panelsRefusedAt().catch(() => null)) ?? null;
      if (layouts.hasNext()) return;
      laidOut = forecast = null;
      take.disabled = true;
      forecasts.replaceChildren();
      const words = `Not possible: ${messageOf(error)}.`;
      if (refused) say('', [{ words, places: [Array.from(refused.vertices)] }]);
      else say(words);
    } finally {
      if (!layouts.hasNext()) work(null);
    }
    draw();
  }

  /** Shows what is being done, with a way to end it; null if nothing is. */
  function work(words: string | null) {
    working.hidden = words === null;
    if (words !== null) setText(doing, words);
  }

  /** Shows the last panels again, with what they were asked for. */
  function goBack({ panels, asked }: NonNullable<typeof laidOut>) {
    wished = { count: asked.count, size: asked.size, boundary: asked.boundary };
    follow.field.value = String(asked.follow);
    even.field.value = String(asked.even);
    show(panels);
  }

  /** Forecasts both choices at the boundary, unless another wish comes first. */
  async function foretell(ask: () => Promise<BoundaryForecast[]>) {
    const mine = turn;
    await new Promise((later) => setTimeout(later, IDLE_MS));
    if (card.hidden || mine !== turn) return;
    isForecasting = true;
    work('Comparing both choices at the boundary …');
    const found = await ask().catch(() => null);
    isForecasting = false;
    if (!layouts.isBusy()) work(null);
    if (card.hidden || mine !== turn || !found) return;
    forecast = found;
    showForecasts();
  }

  function showForecasts() {
    const current = laidOut?.panels.boundary ?? null;
    forecasts.replaceChildren(...boundaryForecasts(BOUNDARIES, forecast, current));
  }

  function show(panels: LaidOut) {
    say(panels.words, panels.notes);
    for (const [of, value] of [
      [count, panels.count],
      [size, panels.size],
    ] as const) {
      of.show(value);
      // What is typed next replaces a number that has come into the field.
      const hasCome = of.field.valueAsNumber === value;
      if (hasCome && document.activeElement === of.field) of.field.select();
    }
    boundaryLine.hidden = panels.boundary === null;
    boundary.value = wished.boundary ?? '';
    showForecasts();
    take.disabled = false;
  }

  function say(words: string, notes: LayoutNote[] = []) {
    const around = (vertices: number[]) =>
      fly(viewport, (view) => view.fitVertices(Uint32Array.from(vertices)));
    said.replaceChildren(...paragraphs(words, notes, around));
  }

  /** Draws the panels over the mesh, whose own edges are hidden meanwhile. */
  function draw() {
    const panels = card.hidden ? null : laidOut?.panels;
    const ring = card.hidden || panels ? null : refused?.points;
    const { points = ring ?? new Float64Array(0), marked = ring ? 1 : 0 } = panels ?? {};
    const ends = panels?.ends ?? Uint32Array.from(ring ? [0, ring.length / 3] : [0]);
    viewport.unmeasured((view) => view.setSurfaceLines(points, ends, marked));
    if (panels && !hidesEdges && store.get().display.edges) {
      hidesEdges = true;
      actions.display({ edges: false });
    } else if (card.hidden && hidesEdges) {
      hidesEdges = false;
      actions.display({ edges: true });
    }
  }

  /** Removes panels that are for another shape. */
  function withdraw() {
    laidOut = null;
    take.disabled = true;
    say('The shape has changed …');
    draw();
  }

  function open() {
    if (!card.hidden) return;
    const { model, kinds, document: scene } = store.get();
    about = model;
    actions.openCorner('new-panels');
    count.show(null);
    size.show(null);
    take.disabled = true;
    wished = {};
    laidOut = refused = null;
    selected = Uint32Array.from(store.get().selection.faces);
    const { length } = selected;
    keeps.label.hidden = !length || length === model?.faces;
    keeps.box.checked = false;
    const faces = `${groupDigits(length)} selected faces stay as they are`;
    setText(keepsWords, length === 1 ? 'The selected face stays as it is' : `The ${faces}`);
    follow.field.value = String(FOLLOW);
    even.field.value = String(EVEN);
    setText(unit, scene?.units ?? '');
    boundaryLine.hidden = true;
    const shapes = kinds.filter((kind) => kind.panels !== null).reverse();
    then.replaceChildren(
      element('option', { value: '' }, 'Nothing more'),
      ...shapes.map(({ id, panels }) => element('option', { value: id }, `Make panels ${panels}`)),
    );
    card.hidden = false;
    update();
    // A field would bring up the keyboard of a phone, over the card.
    (narrow.matches ? closing : count.field).focus();
  }

  function close() {
    if (card.hidden) return;
    card.hidden = true;
    laidOut = refused = null;
    draw();
    // The second worker is free for the next question.
    if (layouts.isBusy() || isForecasting) jobs.cancel();
    actions.leaveCorner('new-panels');
    viewport.element.focus();
  }

  /** Puts the panels in place of the mesh, and makes them one shape if that is asked. */
  async function use() {
    // A number that was typed last.
    await laying;
    if (!laidOut || card.hidden) return;
    const { panels, generation } = laidOut;
    const kind = store.get().kinds.find(({ id }) => id === then.value);
    const taken = await actions.reportErrors(actions.takePanels(generation, panels));
    // The new model has closed the card.
    if (!taken) return taken === false && update();
    const lost = store.get().model?.notes ?? [];
    if (lost.length) alerts.notice(lost.join(' '));
    actions.setStatus(panels.words);
    if (kind) await make(kind);
  }

  // The model is framed in the area above the card.
  const covers = () => cover(viewport, card, narrow.matches ? 'bottom' : null);
  new ResizeObserver(covers).observe(card);
  narrow.addEventListener('change', covers);

  card.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    close();
  });
  jobs.on('told', ({ words }) => {
    if (!card.hidden && layouts.isBusy()) work(words);
  });
  store.subscribe(['model'], ({ model }) => {
    if (model !== about) close();
  });
  store.subscribe(['corner'], ({ corner }) => {
    if (corner !== 'new-panels') close();
  });
  solver.on('frame', () => {
    if (laidOut && laidOut.shape !== solver.geometry?.generation) withdraw();
  });
  // The solver is idle again, after a change.
  solver.on('scene', () => {
    if (!card.hidden && laidOut?.generation !== solver.copy()?.generation) update();
  });
  viewport.on('ready', () => {
    if (!card.hidden) draw();
  });

  return { open };
}
