/** Requests about variations (other shapes that are equally exact). Loaded on first use. */

import { SLICE_MS } from '../solver/messages.js';

/**
 * @param {import("../pkg/engine/shape_up.js").Solver} solver
 * @param {import("./scheduler.js").Scheduler} scheduler
 * @param {import("../solver/messages.js").VariationAsk} ask
 */
export function answer(solver, scheduler, ask) {
  /** @template T @param {() => T} action changes the displayed shape */
  const shows = (action) => {
    const result = action();
    scheduler.frames.due = true;
    scheduler.sendFrame();
    return result;
  };
  switch (ask.what) {
    case 'find':
      scheduler.pause();
      return shows(() => solver.findVariations());
    case 'advance':
      return solver.advanceVariations(SLICE_MS);
    case 'displacement':
      return solver.variation(ask.index);
    case 'show':
      return shows(() => solver.showVariation(ask.coefficients));
    case 'project':
      return shows(() => solver.projectVariation(ask.coefficients) ?? null);
    case 'keep':
      return scheduler.betweenRuns(() => solver.keepVariation());
    case 'leave':
      return shows(() => solver.leaveVariation());
    case 'table':
      return solver.variantTable(ask.tolerance);
    case 'positions':
      return solver.variantPositions(ask.index);
  }
}
