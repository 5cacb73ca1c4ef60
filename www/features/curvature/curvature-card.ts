/**
 * The curvature card: strokes along the principal directions or lines of curvature on the surface,
 * a curvature measure as colours, and the consequences for panels.
 */

import './curvature.css';
import { declared, unitOf } from '../../store/colours/measures.ts';
import { choice, closeButton } from '../../ui/controls/fields.ts';
import { RENEW_MS, element, setText, throttled } from '../../ui/dom.ts';
import { number } from '../../ui/format.ts';
import { once } from '../../ui/once.ts';
import { surfaceLines } from './surface-lines.ts';
import { newestOnly } from '../../store/newest-only.ts';
import type { AppContext } from '../../app/context.ts';
import type { Lines } from '../../solver/types.ts';

const theCard = once(curvatureCard);

export const toggle = (app: AppContext) => theCard(app).toggle();

function curvatureCard(app: AppContext) {
  const { store, solver, viewport, actions } = app;
  /** The colour measure before the card was opened, and whether the user had chosen it. */
  let before = measureNow();
  /** The model of the sentence. */
  let told: unknown = null;

  const lines = choice({ 'aria-label': 'Lines' }, update, [
    ['strokes', 'Principal directions'],
    ['lines', 'Lines of curvature'],
    ['through', 'Lines through the selection'],
    ['', 'No lines'],
  ]);
  lines.value = 'strokes';
  const distance = element('input', {
    type: 'number',
    min: '0',
    step: 'any',
    'aria-label': 'Distance between lines',
    onchange: update,
  });
  const unit = element('span.unit');
  const apart = element('label.apart', element('span', 'Spacing'), distance, unit);
  const colours = choice({ 'aria-label': 'Coloured by' }, () =>
    actions.colourBy(colours.value || null),
  );
  const keys = ['Larger curvature', 'Smaller curvature'].map((words) => {
    const line = element('i');
    return { line, entry: element('span', line, words) };
  });
  const said = element('p.quiet', { 'aria-live': 'polite' });
  const sentence = element('p');
  const card = element(
    'section.card',
    { id: 'curvature', 'aria-labelledby': 'heading-curvature', hidden: true },
    element(
      'div.title',
      element('h2', { id: 'heading-curvature' }, 'Curvature'),
      closeButton('Close curvature', close),
    ),
    lines,
    apart,
    element('div.key', ...keys.map(({ entry }) => entry)),
    element('label.by', element('span', 'Colours'), colours),
    said,
    sentence,
  );
  viewport.element.after(card);

  const NONE = new Uint32Array(0);
  const drawing = surfaceLines(
    app,
    () => {
      if (card.hidden || !lines.value) return null;
      const draw = lines.value as 'strokes' | 'lines' | 'through';
      const { mode, selection } = store.get();
      const through = draw === 'through';
      return {
        draw,
        distance: draw === 'lines' && distance.valueAsNumber > 0 ? distance.valueAsNumber : null,
        vertices: through && mode !== 'faces' ? Uint32Array.from(actions.selectedVertices()) : NONE,
        faces: through && mode === 'faces' ? Uint32Array.from(selection.faces) : NONE,
      };
    },
    (answer, refused) => {
      if (answer && !distance.value) distance.placeholder = number(answer.distance);
      setText(said, refused || wordsOf(answer));
    },
  );

  function wordsOf(answer: Lines | null) {
    const found = (answer?.offsets.length ?? 1) - 1;
    if (lines.value === 'strokes')
      return found ? '' : 'No directions: the surface is flat or equally curved in all directions.';
    if (found) return '';
    return lines.value === 'through'
      ? 'Select vertices or faces to draw the lines through them.'
      : 'No lines of curvature: the surface is flat or equally curved in all directions.';
  }

  function update() {
    apart.hidden = lines.value !== 'lines';
    for (const { entry } of keys) entry.hidden = lines.value === '';
    const colours = viewport.unmeasured((view) => view.lineColours());
    keys.forEach(({ line }, i) => (line.style.background = colours?.[i] ?? ''));
    setText(unit, store.get().document?.units ?? '');
    void drawing.update();
  }

  function measureNow() {
    const { measure, measureChosen } = store.get();
    return { measure, measureChosen };
  }

  const newest = newestOnly(() => store.get().model);

  /** Shows what the curvature means for panels; requested once for each model. */
  async function tell() {
    const { model } = store.get();
    if (told === model || !model) return;
    told = model;
    distance.value = '';
    sentence.hidden = true;
    const forecast = await newest(actions.trials.forecast().catch(() => null));
    if (forecast === undefined) return;
    setText(sentence, forecast?.words ?? '');
    sentence.hidden = !forecast;
  }

  function open() {
    const { measure, measures } = store.get();
    card.hidden = false;
    actions.openCorner('curvature');
    before = measureNow();
    const own = measures.filter(({ curvature }) => curvature);
    if (!own.some(({ id }) => id === measure)) actions.look({ measure: own[0]?.id ?? null });
    void tell();
    update();
    lines.focus();
  }

  function close() {
    card.hidden = true;
    actions.leaveCorner('curvature');
    const { measure } = store.get();
    const about = declared(store.get(), measure);
    if (about?.curvature) actions.look(before);
    update();
  }

  card.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    close();
    viewport.element.focus();
  });
  store.subscribe(['measure', 'measures', 'document'], (state) => {
    const own = state.measures.filter(({ curvature }) => curvature);
    const units = state.document?.units ?? '';
    colours.replaceChildren(
      ...own.map((about) => {
        const { unit: sign } = unitOf(about, 1, units);
        return element('option', { value: about.id }, `${about.label}${sign && ` (${sign})`}`);
      }),
      element('option', { value: '' }, 'Another measure'),
    );
    colours.value = own.some(({ id }) => id === state.measure) ? (state.measure ?? '') : '';
  });
  store.subscribe(['corner'], ({ corner }) => {
    if (corner !== 'curvature' && !card.hidden) close();
  });
  const updateSoon = throttled(RENEW_MS, () => {
    if (!card.hidden) update();
  });
  // The colours of the lines depend on the colours of the faces.
  store.subscribe(['selection', 'mode', 'dark', 'running', 'measure', 'spread'], updateSoon);
  store.subscribe(['model'], () => {
    if (card.hidden) return;
    void tell();
    updateSoon();
  });
  solver.on('frame', updateSoon);

  return { toggle: () => (card.hidden ? open() : close()) };
}
