/**
 * Buttons that make all panels one shape, and those that change the mesh. A disabled one gives the
 * reason; if a change of the mesh is needed first, there is a button for that instead.
 */

import { button } from '../../ui/controls/fields.ts';
import { element, byId } from '../../ui/dom.ts';
import { sketch } from '../../ui/kinds/sketch.ts';
import { openNewPanels } from './new-panels.ts';
import { openRefine } from './refine-dialog.ts';
import { openEdit } from './refine-operation.ts';
import type { KindInfo } from '../../solver/types.ts';
import type { State } from '../../store/state.ts';
import type { AppContext } from '../../app/context.ts';

/** Whether a lesson locks the mesh. */
export const isMeshLocked = ({ document }: Readonly<State>) =>
  document?.lesson?.lock.includes('mesh') ?? false;

/**
 * @param id of the element with the reasons, which describes the buttons
 * @param change opens the operation on the mesh
 */
export function panelButtons(
  state: Readonly<State>,
  id: string,
  press: (kind: KindInfo) => void,
  change: (operation: string) => void,
): { buttons: HTMLButtonElement[]; reasons: HTMLElement[] } {
  const { kinds, model } = state;
  const suggestion = model?.panelSuggestion;
  if (suggestion) {
    const act = () => change(suggestion.operation);
    const disabled = isMeshLocked(state);
    const title = disabled ? 'Locked by the lesson' : '';
    const dialog = { 'aria-haspopup': 'dialog', 'aria-describedby': id };
    return {
      buttons: [button(suggestion.label, act, { ...dialog, disabled, title })],
      reasons: [element('p.quiet', { id }, suggestion.words)],
    };
  }
  const reasonOf: Map<string, string | null> = new Map(
    model?.panels.map(({ kind, reason }) => [kind, reason]),
  );
  // Kinds are listed from the weakest to the strongest requirement; here the strongest comes first.
  const offered = kinds.filter((kind) => kind.panels !== null && reasonOf.has(kind.id)).reverse();
  const buttons = offered.map((kind) => {
    const reason = reasonOf.get(kind.id);
    return element(
      'button.bordered',
      {
        disabled: Boolean(reason),
        title: reason || kind.summary,
        'data-kind': kind.id,
        style: `--chip: rgb(${kind.colour.join(' ')})`,
        ...(reason && { 'aria-describedby': id }),
        onclick: () => press(kind),
      },
      sketch(kind.sketch),
      element('span', `Make panels ${kind.panels}`),
    );
  });
  const reasons = new Set(offered.map((kind) => reasonOf.get(kind.id)).filter(Boolean));
  const words = [...reasons].join(' ');
  return {
    buttons,
    reasons: words ? [element('p.quiet', { id }, words)] : [],
  };
}

/**
 * Adds the buttons that change the mesh to the mesh tools.
 * @param make makes all panels one shape
 */
export function addButtons(app: AppContext, make: (kind: KindInfo) => unknown) {
  const { store, actions } = app;
  const offer = (label: string, open: () => unknown) =>
    button(label, () => actions.reportErrors(open()), { 'aria-haspopup': 'dialog' });
  const buttons = [
    button('New panels', () => openNewPanels(app, make), {
      id: 'new-panels-button',
      title: 'Lays out panels along the lines of curvature',
    }),
    offer('Refine', () => openRefine(app)),
    offer('Edit mesh', () => openEdit(app)),
  ];
  const titles = new Map(buttons.map((one) => [one, one.title]));
  byId('mesh-tools').prepend(...buttons);
  store.subscribe(['model', 'document'], (state) => {
    const { model, document: scene } = state;
    const locked = isMeshLocked(state);
    for (const one of buttons) {
      one.disabled = !model?.faces || model.tets > 0 || !scene || locked;
      one.title = locked ? 'Locked by the lesson' : (titles.get(one) ?? '');
    }
  });
}
