/**
 * Two pictures of the model in place of one, left and right of a divider. Their controls come with
 * `split-view.js` when they are first asked for.
 */

import { messageOf } from '../../solver/messages.js';

/** @typedef {import("../../store/view-modes.js").Choice} Choice */

/**
 * Shows two pictures with what was chosen last, or one again.
 * @param {import("../../app/context.js").AppContext} parts
 */
export function toggleSplit(parts) {
  if (parts.store.get().split) parts.store.set({ split: null, status: 'One picture' });
  else splitInto(parts);
}

/**
 * Shows two pictures.
 * @param {import("../../app/context.js").AppContext} parts
 * @param {[Choice, Choice]} [choices] left and right
 */
export async function splitInto(parts, choices) {
  try {
    const { SplitView } = await import('./split-view.js');
    await SplitView.of(parts).open(choices);
  } catch (error) {
    parts.alerts.error(messageOf(error));
  }
}
