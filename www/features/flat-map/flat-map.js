/** The flat map beside the model. How it is made, and its panel, come when it is first asked for. */

import { messageOf } from '../../solver/messages.js';

/**
 * Shows the map of the model that is open, or takes it away.
 * @param {import("./uv-controller.js").Parts} parts
 */
export async function toggleFlatMap(parts) {
  try {
    const { Parametrize } = await import('./uv-controller.js');
    await Parametrize.of(parts).toggle();
  } catch (error) {
    parts.alerts.error(messageOf(error));
  }
}
