/** Requests about variations (other shapes that are equally exact). Loaded on first use. */

import { SLICE_MS, type VariationAsk } from '../solver/messages.ts';
import type { Solver } from '../pkg/engine/shape_up.js';
import type { Scheduler } from './scheduler.ts';

export function answer(solver: Solver, scheduler: Scheduler, ask: VariationAsk) {
  /** @param action changes the displayed shape */
  const shows = <T>(action: () => T) => {
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
