/**
 * Two pictures of the model in place of one, left and right of a divider. Their controls come with
 * `split-view.js` when they are first asked for.
 */

import { messageOf } from '../../solver/messages.js';

/** @typedef {import("../../store/view-modes.js").Choice} Choice */

/**
 * Shows two pictures with what was chosen last, or one again.
 * @param {import("../../app/context.js").AppContext} app
 */
export function toggleSplit(app) {
  if (app.store.get().split) app.store.set({ split: null, status: 'One picture' });
  else splitInto(app);
}

/**
 * Shows two pictures.
 * @param {import("../../app/context.js").AppContext} app
 * @param {[Choice, Choice]} [choices] left and right
 */
export async function splitInto(app, choices) {
  try {
    const { SplitView } = await import('./split-view.js');
    await SplitView.of(app).open(choices);
  } catch (error) {
    app.alerts.error(messageOf(error));
  }
}
