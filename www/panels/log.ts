/** The log: a report on the file, and the messages since the page was opened. */

import '../ui/styles/lists.css';
import { button } from '../ui/controls/fields.ts';
import { element, setText } from '../ui/dom.ts';
import { count } from '../ui/format.ts';
import { copyText } from '../ui/output.ts';
import { showElements } from '../viewport/camera.ts';
import type { AppContext } from '../app/context.ts';
import type { Loaded } from '../solver/types.ts';

const FORMATS = { z: 'z-up', y: 'y-up' };
const NAMES = { error: 'Error', notice: 'Notice', status: '' };

export function logOf(panel: HTMLElement, app: AppContext) {
  const { store, alerts, actions } = app;
  const file = element('div.import-report');
  // Focusable, so that it can be scrolled by keyboard.
  const list = element('ol.log', { 'aria-label': 'Messages', tabindex: 0 });
  const copyResult = element('span.quiet', { 'aria-live': 'polite' });
  panel.append(
    element('h3', 'File'),
    file,
    element('h3', 'Messages'),
    list,
    element('p.log-end', button('Copy as text', copy), copyResult),
  );

  /** Selects the elements affected by a problem. */
  const select = (flaw: string) => actions.begin(selectFlaw(flaw));

  async function selectFlaw(flaw: string) {
    const found = await actions.reportErrors(actions.ask.flawed(flaw));
    if (!found) return;
    const some = found.vertices.length + found.edges.length + found.faces.length;
    if (some > 0) showElements(app, found);
    else actions.setStatus('No elements with this problem are left');
  }

  store.subscribe(['model', 'document'], ({ model, document }) => {
    if (!model) return;
    const lines = factsOf(model, document?.units ?? model.units, document?.up ?? model.up);
    const problems = model.problems.map(({ message, flaw }) =>
      element(
        'li.problem',
        element('span.mark', { 'aria-hidden': 'true' }, '!'),
        element('span', message),
        flaw &&
          button('Select', () => select(flaw), {
            class: 'small bordered',
            'aria-label': `Select: ${message}`,
          }),
      ),
    );
    const notes = model.notes.map((note) => element('li.quiet', note));
    const list = element('ul', { 'aria-label': 'Problems and notes' }, ...problems, ...notes);
    file.replaceChildren(...lines.map((line) => element('p', line)));
    if (list.hasChildNodes()) file.append(list);
  });

  function showMessages() {
    list.replaceChildren(
      ...alerts.journal
        .toReversed()
        .map(({ time, kind, text }) =>
          element(
            'li',
            { class: kind },
            element('time', { datetime: time.toISOString() }, clock(time)),
            element('span', NAMES[kind] && element('strong', `${NAMES[kind]}: `), text),
          ),
        ),
    );
  }
  alerts.listen(showMessages);
  showMessages();

  async function copy() {
    const { model, document } = store.get();
    const lines = [
      ...(model
        ? [
            ...factsOf(model, document?.units ?? model.units, document?.up ?? model.up),
            ...model.problems.map(({ message }) => `Problem: ${message}`),
            ...model.notes.map((note) => `Note: ${note}`),
            '',
          ]
        : []),
      ...alerts.journal.map(
        ({ time, kind, text }) =>
          `${time.toISOString()} ${NAMES[kind] && `${NAMES[kind]}: `}${text}`,
      ),
    ];
    setText(
      copyResult,
      await copyText(`${lines.join('\n')}\n`, 'The browser did not allow copying.'),
    );
  }
}

const clock = (time: Date) => time.toTimeString().slice(0, 8);

/** Returns the contents of the file, a sentence each. */
function factsOf(model: Loaded, units: string, up: 'y' | 'z') {
  const guessed = (is: boolean) => (is ? ' (guessed)' : '');
  const parts = [
    count(model.vertices, 'vertex', 'vertices'),
    count(model.faces, 'face'),
    ...(model.curves > 0 ? [count(model.curves, 'curve')] : []),
    ...(model.tets > 0 ? [count(model.tets, 'tetrahedron', 'tetrahedra')] : []),
    ...(model.groups.length > 0 ? [count(model.groups.length, 'group')] : []),
  ];
  const problems = model.problems.length;
  return [
    `${model.name}: ${parts.join(', ')}`,
    `Unit: ${units || 'unknown'}${guessed(model.guessed.units)} · ${FORMATS[up]}${guessed(model.guessed.up)}`,
    problems > 0 ? count(problems, 'kind of problem', 'kinds of problem') : 'No problems',
  ];
}
