/** A second file whose surface the open mesh is kept close to, instead of to its own. */

import { messageOf } from '../../solver/messages.js';

/**
 * One step of undo; the alert says why where the file is refused.
 * @param {File} file OBJ, OFF or Medit
 * @param {import("../../solver/solver-client.js").SolverClient} solver
 * @param {import("../../ui/controls/alerts.js").Alerts} alerts
 */
export async function fitTo(file, solver, alerts) {
  try {
    const text = await file.text();
    await solver.request({ type: 'edit', edit: { type: 'fitTo', name: file.name, text } });
  } catch (error) {
    alerts.error(messageOf(error));
  }
}
