/** The model: its name, its contents, and the problems of its file. */

import { button } from '../ui/controls/fields.ts';
import { element } from '../ui/dom.ts';
import { count, groupDigits } from '../ui/format.ts';
import { meshActions } from '../store/mesh-actions.ts';
import { frameFields } from '../documents/units-prompt.ts';
import type { AppContext } from '../app/context.ts';
import type { Loaded, MeshSuggestion } from '../solver/types.ts';

/** @param showLog opens the log, with the details of each problem */
export function modelPanel(place: HTMLElement, app: AppContext, showLog: () => void) {
  const { store, solver, actions } = app;
  const frame = frameFields(app);
  const mesh = meshActions(store, solver, actions);
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
      ...report(model, showLog, mend),
    );
  });

  function mend({ label, words, operation }: MeshSuggestion) {
    const change = () => actions.reportErrors(mesh.remesh({ operation }, label));
    return button(label, change, { class: 'small bordered', title: words });
  }
}

function optional(name: string, value: number): [string, string][] {
  return value > 0 ? [[name, groupDigits(value)]] : [];
}

function facts(rows: [string, string][]) {
  return element(
    'dl.facts',
    ...rows.flatMap(([name, value]) => [element('dt', name), element('dd', value)]),
  );
}

function groups(model: Loaded) {
  if (model.groups.length === 0) return [];
  const rows = model.groups.map((group) =>
    element('li', `${group.name}: ${count(group.faces, 'face')}`),
  );
  const shown = details(count(model.groups.length, 'group'), rows, false);
  return [shown];
}

/**
 * The import report.
 * @param mend button that changes the mesh
 */
function report(
  model: Loaded,
  showLog: () => void,
  mend: (suggestion: MeshSuggestion) => HTMLButtonElement,
) {
  const problems = model.problems.map(({ message, suggestion }) =>
    element('li', message, suggestion && ' ', suggestion && mend(suggestion)),
  );
  const notes = model.notes.map((note) => element('li.quiet', note));
  if (problems.length + notes.length === 0) return [];
  const title =
    problems.length > 0
      ? `${count(problems.length, 'problem')} in the file`
      : count(notes.length, 'note');
  const more = button('Details', showLog, { class: 'small bordered' });
  const shown = details(title, [...problems, ...notes], problems.length > 0);
  shown.append(more);
  return [shown];
}

function details(title: string, rows: HTMLElement[], open: boolean) {
  return element('details.report', { open }, element('summary', title), element('ul', ...rows));
}
