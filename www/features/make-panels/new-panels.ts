/**
 * The card of new panels: they are laid out along the lines of curvature in the second worker, drawn
 * over the mesh, and taken in its place.
 */

import './new-panels.css';
import { button, choice, closeButton } from '../../ui/controls/fields.ts';
import { element, setText } from '../../ui/dom.ts';
import { once } from '../../ui/once.ts';
import { Cancelled, messageOf } from '../../solver/errors.ts';
import { latestOnly } from '../../store/latest-only.ts';
import type { AppContext } from '../../app/context.ts';
import type { KindInfo } from '../../solver/types.ts';
import type { LaidOut, LayoutSettings } from '../../pkg/engine/shape_up.js';

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

function newPanelsCard(
  { store, solver, jobs, viewport, actions, alerts }: AppContext,
  make: (kind: KindInfo) => unknown,
) {
  /** The panels that are shown, and the generation of the model that they are for. */
  let laidOut: { panels: LaidOut; generation: number } | null = null;
  /** The model that the card is about. */
  let about: unknown = null;
  /** Whether the mesh edges were shown before the card was opened. */
  let hadEdges = true;
  /** The fields that the user has set. */
  let wished: Pick<LayoutSettings, 'count' | 'size' | 'boundary'> = {};

  const count = number('Panels', { min: '1', step: '1' }, (count) => {
    wished = { ...wished, count, size: null };
  });
  const size = number('Side', { min: '0', step: 'any' }, (size) => {
    wished = { ...wished, size, count: null };
  });
  const unit = element('span.unit');
  const follow = slider('Fewer irregular points', 'Smaller move', FOLLOW);
  const even = slider('Smaller move', 'Even sizes', EVEN);
  const boundary = choice(
    {},
    (value) => {
      wished = { ...wished, boundary: value as LayoutSettings['boundary'] };
      update();
    },
    [
      ['follow', 'Followed by the panels'],
      ['cut', 'Cuts the panels'],
    ],
  );
  const boundaryLine = element('label', element('span', 'Boundary'), boundary);
  const then = choice({}, () => {});
  const said = element('div.said', { 'aria-live': 'polite' });
  const take = button('Use these panels', use, { class: 'primary' });
  const card = element(
    'section.card',
    { id: 'new-panels', 'aria-labelledby': 'heading-new-panels', hidden: true },
    element(
      'div.title',
      element('h2', { id: 'heading-new-panels' }, 'New panels'),
      closeButton('Close new panels', close),
    ),
    element('div.sizes', count.label, element('label', ...size.label.childNodes, unit)),
    follow.place,
    even.place,
    boundaryLine,
    said,
    element('label', element('span', 'Then'), then),
    take,
  );
  viewport.element.after(card);

  function number(
    label: string,
    attributes: { min: string; step: string },
    wish: (value: number) => void,
  ) {
    const field = element('input', {
      ...{ type: 'number', ...attributes },
      onchange: () => {
        if (!field.validity.valid || !(field.valueAsNumber > 0)) return;
        wish(field.valueAsNumber);
        update();
      },
    });
    return { field, label: element('label', element('span', label), field) };
  }

  function slider(low: string, high: string, value: number) {
    const field = element('input', {
      ...{ type: 'range', min: '0', max: '1', step: '0.05', value: String(value) },
      'aria-label': `${low} to ${high.toLowerCase()}`,
      oninput: update,
    });
    const ends = element('div.ends', element('span', low), element('span', high));
    return { field, place: element('div.slider', field, ends) };
  }

  const layouts = latestOnly(layOut);

  function update() {
    void layouts.ask();
  }

  async function layOut() {
    const model = solver.copy();
    if (card.hidden || !model) return;
    say(['Laying out panels …']);
    take.disabled = true;
    const settings = {
      ...wished,
      follow: follow.field.valueAsNumber,
      even: even.field.valueAsNumber,
    };
    try {
      const panels = await jobs.ask.layOutPanels(model, settings);
      if (card.hidden || about !== store.get().model) return;
      laidOut = { panels, generation: model.generation };
      show(panels);
    } catch (error) {
      laidOut = null;
      if (error instanceof Cancelled) return close();
      say([`Not possible: ${messageOf(error)}.`]);
    }
    draw();
  }

  function show(panels: LaidOut) {
    say(panels.words);
    count.field.value = String(panels.count);
    size.field.value = String(panels.size);
    boundaryLine.hidden = panels.boundary === null;
    boundary.value = panels.boundary ?? '';
    take.disabled = false;
  }

  function say(sentences: string[]) {
    said.replaceChildren(...sentences.map((words) => element('p', words)));
  }

  /** Draws the panels over the mesh, whose own edges are hidden meanwhile. */
  function draw() {
    const panels = card.hidden ? null : laidOut?.panels;
    const { points = new Float64Array(0), ends = new Uint32Array(1), irregular = 0 } = panels ?? {};
    viewport.unmeasured((view) => view.setSurfaceLines(points, ends, irregular));
    actions.display({ edges: panels ? false : hadEdges });
  }

  function open() {
    if (!card.hidden) return;
    const { model, display, kinds, document: scene } = store.get();
    about = model;
    hadEdges = display.edges;
    wished = {};
    laidOut = null;
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
    count.field.focus();
  }

  function close() {
    if (card.hidden) return;
    card.hidden = true;
    laidOut = null;
    draw();
    viewport.element.focus();
  }

  /** Puts the panels in place of the mesh, and makes them one shape if that is asked. */
  async function use() {
    if (!laidOut) return;
    const { panels, generation } = laidOut;
    const kind = store.get().kinds.find(({ id }) => id === then.value);
    close();
    const taken = await actions.reportErrors(actions.takePanels(generation, panels));
    if (taken === false) return actions.setStatus('The mesh has changed meanwhile: try again');
    if (!taken) return;
    const lost = store.get().model?.notes ?? [];
    if (lost.length) alerts.notice(lost.join(' '));
    actions.setStatus(panels.words[0]);
    if (kind) await make(kind);
  }

  card.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    close();
  });
  jobs.on('told', ({ words }) => {
    if (!card.hidden && layouts.isBusy()) say([words]);
  });
  store.subscribe(['model'], ({ model }) => {
    if (model !== about) close();
  });
  viewport.on('ready', () => {
    if (!card.hidden) draw();
  });

  return { open };
}
