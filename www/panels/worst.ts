/**
 * The table of the worst elements: the values behind the colours. The worker finds them; it is
 * queried while the table is visible, a few times a second during a run.
 */

import '../ui/styles/lists.css';
import { itemByKey } from '../ui/controls/navigation.ts';
import { choice, setOptions } from '../ui/controls/fields.ts';
import { element, setText, throttled } from '../ui/dom.ts';
import { length } from '../ui/format.ts';
import {
  declared,
  measureOfScene,
  movedInWords,
  roundingOf,
  toleranceOf,
  valueInWords,
} from '../store/colours/measures.ts';
import { newestOnly } from '../store/newest-only.ts';
import { lengthOrZero } from '../ui/rounding.ts';
import { showElements } from '../viewport/camera.ts';
import type { FaceMeasure, WorstElement } from '../solver/types.ts';
import type { AppContext } from '../app/context.ts';

const ROWS = 20;
const ASK_EVERY_MS = 300;
/** The option for the measure that colours the faces, or would by default. */
const COLOURS = 'colours';

export function worstElements(panel: HTMLElement, app: AppContext) {
  const { store, actions } = app;
  /** The elements in the rows of the table. */
  let shown: WorstElement[] = [];
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

  function offer() {
    const state = store.get();
    const about = declared(state, state.measure ?? measureOfScene(state));
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
    const about =
      by.value === COLOURS ? declared(state, state.measure ?? measureOfScene(state)) : undefined;
    const worst = () => {
      if (by.value === '') return [];
      if (about) return actions.ask.worstFaces(about.id, ROWS);
      return actions.ask.worstConstraints(Number(by.value), ROWS);
    };
    const found = await newest(actions.reportErrors(worst()));
    if (found) fill(found, about);
  });

  /** @param about not for constraints */
  function fill(found: WorstElement[], about: FaceMeasure | undefined) {
    const state = store.get();
    const { document, size } = state;
    const units = document?.units ?? '';
    const tolerance = about ? toleranceOf(state, about) : state.tolerance;
    const moved = movedInWords(state);
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
      const text = about
        ? valueInWords(
            about,
            Math.abs(worst.value) < roundingOf(about, size) ? 0 : worst.value,
            units,
            tolerance,
          )
        : length(lengthOrZero(worst.value, size), units, tolerance ?? worst.value);
      setText(button, worst.element);
      setText(value, text);
      setText(constraint, [worst.constraint, ...worst.groups].filter(Boolean).join(' · ') || '–');
      button.title = 'Select and zoom to it';
    });
  }

  new IntersectionObserver(([entry]) => {
    inSight = entry.isIntersecting;
    if (inSight) ask();
  }).observe(panel);
  store.subscribe(['document', 'measure', 'model'], offer);
  store.subscribe(['numbers', 'running', 'tolerance', 'tolerances'], () => ask());
}
