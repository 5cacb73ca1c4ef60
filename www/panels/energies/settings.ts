/** Advanced settings of a scene: closeness, smoothness, solver. Built from their declarations. */

import './settings.css';
import { button } from '../../ui/controls/fields.ts';
import { element, setText } from '../../ui/dom.ts';
import { count } from '../../ui/format.ts';
import { Parameters } from '../../ui/kinds/parameters.ts';
import { sizeOfSelection } from '../../store/selection.ts';
import type { Store } from '../../store/state.ts';
import type { Actions } from '../../store/actions.ts';
import type { Edit, ParamValue, SettingInfo } from '../../solver/types.ts';

/** Fitting to another surface. */
const FIT = {
  label: 'Fit to another surface',
  edit: (name: string, text: string): Edit => ({ fitTo: { name, text } }),
  words: 'A second file in the same coordinates: the vertices are pulled onto its surface.',
  done: (name: string) => `Vertices stay near ${name}`,
};
/** Rest shapes from another pose. */
const POSE = {
  label: 'Take the pose of another file',
  edit: (name: string, text: string): Edit => ({ takePose: { name, text } }),
  words:
    'A second file with the same faces: rigid and similar constraints keep the shapes in that file.',
  done: (name: string) => `Shapes are taken from ${name}`,
};

/** Closeness buttons for the selected vertices, with factors of the weight of closeness. */
const HOLDS = [
  { label: 'More', weight: 10, title: 'Ten times the closeness of the others' },
  { label: 'Less', weight: 0.1, title: 'A tenth of the closeness of the others' },
  { label: 'Release', weight: 0, title: 'Nothing keeps them near the original' },
  { label: 'Default', weight: 1, title: 'The same closeness as the others' },
];

export function settingsPanel(place: HTMLElement, store: Store, actions: Actions) {
  const { settings } = store.get();
  const rows = settings.map((setting) => settingRow(setting, store, actions));
  const groups = [...new Set(settings.map(({ group }) => group))];
  const inGroup = (group: string) =>
    rows.filter((_, i) => settings[i].group === group).map(({ row }) => row);
  const [first, ...others] = groups;
  place.replaceChildren(
    element('h3', first ?? ''),
    ...inGroup(first),
    fileRow(FIT, actions),
    poseRow(store, actions),
    holdRow(store, actions),
    ...others.flatMap((group) => [element('h3', group), ...inGroup(group)]),
  );
  let shown = '';
  store.subscribe(['document'], ({ document }) => {
    const values = document?.settings;
    if (!values || JSON.stringify(values) === shown) return;
    shown = JSON.stringify(values);
    rows.forEach(({ show }) => show(values));
  });
}

function settingRow(setting: SettingInfo, store: Store, actions: Actions) {
  const { document, model } = store.get();
  const parameters = new Parameters([setting], document?.settings ?? {}, model, {
    changed: (id, value) =>
      actions.edit({ set: { id, value } }, (error) => {
        const now = store.get().document?.settings;
        if (now) parameters.restore(now);
        return parameters.refuse(error);
      }),
  });
  const row = element('div.setting', parameters.element, element('p.quiet', setting.summary));
  return {
    row,
    show: (values: Record<string, ParamValue>) => parameters.restore(values),
  };
}

/**
 * A row with a file input for an edit that reads a second file.
 * @param more elements beside the button
 */
function fileRow(
  { label, edit, words, done }: typeof FIT,
  actions: Actions,
  ...more: HTMLElement[]
) {
  const read = async (file: File) => {
    const text = await file.text();
    input.value = '';
    const edited = await actions.edit(edit(file.name, text));
    if (edited !== undefined) actions.setStatus(done(file.name));
  };
  const input = element('input', {
    type: 'file',
    accept: '.obj,.off,.mesh',
    'aria-label': label,
    onchange: () => {
      const [file] = input.files ?? [];
      if (file) void actions.reportErrors(read(file));
    },
  });
  return element(
    'div.setting',
    element('label.button', `${label} …`, input),
    ...more,
    element('p.quiet', words),
  );
}

/** The row for rest shapes from another pose of the mesh. */
function poseRow(store: Store, actions: Actions) {
  const leave = button('Leave the other pose', () => actions.edit('leavePose'));
  store.subscribe(['document'], ({ document }) => (leave.hidden = !document?.pose));
  return fileRow(POSE, actions, leave);
}

/** The row for the closeness of the selected vertices relative to the others. */
function holdRow(store: Store, actions: Actions) {
  const note = element('p.quiet');
  const hold = async ({ label, weight }: (typeof HOLDS)[number]) => {
    await actions.settled();
    const vertices = actions.selectedVertices();
    if ((await actions.edit({ holdClose: { vertices, weight } })) === undefined) return;
    const whose = count(vertices.length, 'vertex', 'vertices');
    actions.setStatus(`Closeness of ${whose}: ${label.toLowerCase()}`);
  };
  const buttons = HOLDS.map((one) =>
    button(one.label, () => hold(one), {
      title: one.title,
      'aria-label': `Closeness of the selection: ${one.label.toLowerCase()}`,
    }),
  );
  const all = button('Same for all', () =>
    actions.edit({ holdClose: { vertices: null, weight: 1 } }),
  );
  store.subscribe(['selection', 'document'], ({ selection, document }) => {
    const none = sizeOfSelection(selection) === 0;
    buttons.forEach((button) => (button.disabled = none));
    const held = document?.reweightedVertices ?? 0;
    all.hidden = held === 0;
    const words = none
      ? 'Select vertices to keep them closer to the original, or less close, than the others.'
      : '';
    const others =
      held > 0 ? `${count(held, 'vertex has its', 'vertices have their')} own closeness.` : '';
    setText(note, [words, others].filter(Boolean).join(' '));
  });
  return element(
    'div.setting',
    { role: 'group', 'aria-label': 'Closeness of the selection' },
    element('p', 'Closeness of the selection'),
    element('div.row-buttons', ...buttons, all),
    note,
  );
}
