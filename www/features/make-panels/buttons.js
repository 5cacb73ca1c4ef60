/**
 * Buttons that make all panels one shape; a disabled one gives the reason. If a change of the mesh is
 * needed first, there is a button for that instead.
 */

import { button } from '../../ui/controls/fields.js';
import { element } from '../../ui/dom.js';
import { sketch } from '../../ui/kinds/sketch.js';

/** @typedef {import("../../solver/messages.js").KindInfo} KindInfo */
/** @typedef {import("../../store/state.js").State} State */

/** Whether a lesson locks the mesh. @param {Readonly<State>} state */
export const isMeshLocked = ({ document }) => document?.lesson?.lock.includes('mesh') ?? false;

/**
 * @param {Readonly<State>} state
 * @param {string} id of the element with the reasons, which describes the buttons
 * @param {(kind: KindInfo) => void} press
 * @param {(operation: string) => void} change opens the operation on the mesh
 * @returns {{ buttons: HTMLButtonElement[], reasons: HTMLElement[] }}
 */
export function panelButtons(state, id, press, change) {
  const { kinds, model } = state;
  const remedy = model?.panelRemedy;
  if (remedy) {
    const act = () => change(remedy.operation);
    const disabled = isMeshLocked(state);
    const title = disabled ? 'Locked by the lesson' : '';
    const dialog = { 'aria-haspopup': 'dialog', 'aria-describedby': id };
    return {
      buttons: [button(remedy.label, act, { ...dialog, disabled, title })],
      reasons: [element('p.quiet', { id }, remedy.words)],
    };
  }
  /** @type {Map<string, string | null>} */
  const reasonOf = new Map(model?.panels.map(({ kind, reason }) => [kind, reason]));
  // Kinds are listed from the weakest to the strongest requirement; here the strongest comes first.
  const offered = kinds.filter((kind) => kind.panels !== null && reasonOf.has(kind.id)).reverse();
  const buttons = offered.map((kind) => {
    const reason = reasonOf.get(kind.id);
    return element(
      'button.bordered',
      {
        disabled: Boolean(reason),
        title: reason || kind.summary,
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
