/** The flat map beside the model. How it is made, and its panel, come when it is first asked for. */

/**
 * Shows the map of the model that is open, or takes it away.
 * @param {import("../../app/context.js").AppContext} app
 */
export async function toggleFlatMap(app) {
  const map = import('./uv-controller.js').then((it) => it.Parametrize.of(app).toggle());
  await app.actions.reportErrors(map);
}
