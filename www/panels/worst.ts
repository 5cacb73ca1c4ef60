/**
 * The table of the worst elements: the values behind the colours. The worker finds them; it is
 * queried while the table is visible, a few times a second during a run.
 */

import '../ui/styles/lists.css';
import { itemByKey } from '../ui/controls/navigation.ts';
import { choice, setOptions } from '../ui/controls/fields.ts';
import { element, setText, throttled } from '../ui/dom.ts';
import { declared, movedInWords, toleranceOf } from '../store/colours/measures.ts';
import { newestOnly } from '../store/newest-only.ts';
import { showElements } from '../viewport/camera.ts';
import type { FaceMeasure, WorstRow } from '../solver/types.ts';
import type { State } from '../store/state.ts';
import type { AppContext } from '../app/context.ts';

const ROWS = 20;
const ASK_EVERY_MS = 300;
/** The option for the measure that colours the faces, or would by default. */
const COLOURS = 'colours';

export function worstElements(panel: HTMLElement, app: AppContext) {
  const { store, actions } = app;
  /** The elements in the rows of the table. */
  let shown: WorstRow[] = [];
  let inSight = false;
  const newest = newestOnly();

  const by = choice({ 'aria-label': 'Worst by' }, () => ask());
  const words = element('p.quiet');
  const body = element('tbody');
  const heading = element('th.figure', { scope: 'col' }, 'Error');
  const table = element(
    'table.worst-elements',
    { 'aria-label': 'Worst elements' },
    element(
      'thead',
      element(
        'tr',
        element('th', { scope: 'col' }, 'Element'),
        element('th', { scope: 'col' }, 'Constraint'),
        heading,
      ),
    ),
    body,
  );
  panel.append(element('label.worst-by', 'By', by), words, table);

  const rows = Array.from({ length: ROWS }, (_, index) => {
    const button = element('button', { onclick: () => show(index) });
    const row = element('th', { scope: 'row' }, button);
    const constraint = element('td');
    const value = element('td.figure');
    const line = element('tr', { hidden: true }, row, constraint, value);
    body.append(line);
    return { line, button, constraint, value };
  });
  body.addEventListener('keydown', (event) => {
    const buttons = rows.slice(0, shown.length).map(({ button }) => button);
    itemByKey(event, buttons, { along: 'y', wraps: false, ends: true })?.focus();
  });

  function show(index: number) {
    const worst = shown[index];
    if (worst) showElements(app, worst);
  }

  /** The measure that colours the faces, or would by default. */
  const colouring = (state: Readonly<State>) =>
    declared(state, state.measure ?? state.document?.measure ?? null);

  function offer() {
    const state = store.get();
    const about = colouring(state);
    const choices = [
      ...(about && state.model?.faces ? [[COLOURS, about.label]] : []),
      ...(state.document?.constraints ?? []).map((row) => [
        String(row.index),
        `Constraint: ${row.label} on ${row.on}`,
      ]),
    ];
    setOptions(by, choices);
    by.disabled = choices.length === 0;
    ask();
  }

  const ask = throttled(ASK_EVERY_MS, async () => {
    const state = store.get();
    if (!inSight || !state.model) return;
    const about = by.value === COLOURS ? colouring(state) : undefined;
    const tolerance = (about ? toleranceOf(state, about) : state.document?.tolerance) ?? undefined;
    const worst = () => {
      if (by.value === '') return [];
      if (about) return actions.ask.worstFaces(about.id, ROWS, tolerance);
      return actions.ask.worstConstraints(Number(by.value), ROWS, tolerance);
    };
    const found = await newest(actions.reportErrors(worst()));
    if (found) fill(found, about);
  });

  /** @param about not for constraints */
  function fill(found: WorstRow[], about: FaceMeasure | undefined) {
    const moved = movedInWords(store.get());
    shown = found;
    const what = about?.words ?? 'largest distance of a vertex from the shape of its constraint';
    const nothing = 'No constraints, or no values.';
    const said = `The ${what}.${moved && ` Moved ${moved}.`}`;
    setText(words, found.length === 0 ? nothing : said);
    table.hidden = found.length === 0;
    rows.forEach(({ line, button, constraint, value }, index) => {
      const worst = found[index];
      line.hidden = !worst;
      if (!worst) return;
      setText(button, worst.element);
      setText(value, worst.words);
      setText(constraint, worst.about);
      button.title = 'Select and zoom to it';
    });
  }

  new IntersectionObserver(([entry]) => {
    inSight = entry.isIntersecting;
    if (inSight) ask();
  }).observe(panel);
  store.subscribe(['document', 'measure', 'model'], offer);
  store.subscribe(['numbers', 'running', 'document', 'tolerances'], () => ask());
}
