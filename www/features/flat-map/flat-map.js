/** The flat map beside the model. How it is made, and its panel, come when it is first asked for. */

import { messageOf } from '../../solver/messages.js';

/**
 * Shows the map of the model that is open, or takes it away.
 * @param {import("../../app/context.js").AppContext} app
 */
export async function toggleFlatMap(app) {
  try {
    const { Parametrize } = await import('./uv-controller.js');
    await Parametrize.of(app).toggle();
  } catch (error) {
    app.alerts.error(messageOf(error));
  }
}
