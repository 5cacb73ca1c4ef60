/**
 * Two pictures of the model in place of one, left and right of a divider. Their controls come with
 * `split-view.js` when they are first asked for.
 */

/** @typedef {import("../../store/view-modes.js").Choice} Choice */

/**
 * Shows two pictures with what was chosen last, or one again.
 * @param {import("../../app/context.js").AppContext} app
 */
export function toggleSplit(app) {
  if (app.store.get().split) app.actions.look({ split: null, status: 'One picture' });
  else splitInto(app);
}

/**
 * Shows two pictures.
 * @param {import("../../app/context.js").AppContext} app
 * @param {[Choice, Choice]} [choices] left and right
 */
export async function splitInto(app, choices) {
  const view = import('./split-view.js').then((it) => it.SplitView.of(app).open(choices));
  await app.actions.reportErrors(view);
}
