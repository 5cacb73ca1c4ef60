/** The model: its name, its contents, and the problems of its file. */

import { button } from '../../ui/controls/fields.js';
import { element } from '../../ui/dom.js';
import { count, groupDigits } from '../../ui/format.js';
import { frameFields } from '../../documents/units-prompt.js';

/**
 * @param {HTMLElement} place
 * @param {import("../../app/context.js").AppContext} app
 * @param {() => void} showLog opens the log, with the details of each problem
 */
export function modelPanel(place, { store, actions }, showLog) {
  const frame = frameFields(store, actions);
  store.subscribe(['model', 'fileName'], ({ model, fileName }) => {
    if (!model) return;
    place.replaceChildren(
      element('p.model-name', model.title || fileName),
      facts([
        ['Vertices', groupDigits(model.vertices)],
        ['Faces', groupDigits(model.faces)],
        ...optional('Curves', model.curves),
        ...optional('Tetrahedra', model.tets),
        ...optional('Groups', model.groups.length),
      ]),
      frame,
      ...groups(model),
      ...report(model, showLog),
    );
  });
}

/**
 * @param {string} name
 * @param {number} value
 * @returns {[string, string][]}
 */
function optional(name, value) {
  return value > 0 ? [[name, groupDigits(value)]] : [];
}

/** @param {[string, string][]} rows */
function facts(rows) {
  return element(
    'dl.facts',
    ...rows.flatMap(([name, value]) => [element('dt', name), element('dd', value)]),
  );
}

/** @param {import("../../solver/messages.js").Loaded} model */
function groups(model) {
  if (model.groups.length === 0) return [];
  const rows = model.groups.map((group) =>
    element('li', `${group.name}: ${count(group.faces, 'face')}`),
  );
  const shown = details(count(model.groups.length, 'group'), rows, false);
  shown.classList.add('advanced');
  return [shown];
}

/**
 * The import report.
 * @param {import("../../solver/messages.js").Loaded} model
 * @param {() => void} showLog
 */
function report(model, showLog) {
  const problems = model.problems.map((problem) => element('li', problem.message));
  const notes = model.notes.map((note) => element('li.quiet', note));
  if (problems.length + notes.length === 0) return [];
  const title =
    problems.length > 0
      ? `${count(problems.length, 'problem')} in the file`
      : count(notes.length, 'note');
  const more = button('Details', showLog, { class: 'small bordered' });
  const shown = details(title, [...problems, ...notes], problems.length > 0);
  shown.classList.toggle('advanced', problems.length === 0);
  shown.append(more);
  return [shown];
}

/**
 * @param {string} title
 * @param {HTMLElement[]} rows
 * @param {boolean} open
 */
function details(title, rows, open) {
  return element('details.report', { open }, element('summary', title), element('ul', ...rows));
}
