/**
 * Opens and closes the split view: two pictures of the model, left and right of a divider. Its
 * controls are loaded with `split-view.js` on first use.
 */

/** @typedef {import("../../store/view-modes.js").Choice} Choice */

/**
 * Toggles the split view, which opens with the choices made last.
 * @param {import("../../app/context.js").AppContext} app
 */
export function toggleSplit(app) {
  if (app.store.get().split) app.actions.look({ split: null, status: 'Split view closed' });
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
