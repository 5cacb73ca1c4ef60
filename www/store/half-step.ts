/** The two halves of an iteration (Fig. 4 of the paper) in words. */

import { groupDigits } from '../ui/words.ts';
import type { HalfStep } from '../pkg/engine/shape_up.js';

export function halfStepTitle({ halfway }: { halfway: boolean }) {
  return halfway
    ? 'Global step: move all vertices to the least-squares solution'
    : 'Local step: fit a shape to each constraint; nothing moves yet';
}

/** Describes a half step and the next. */
export function halfStepWords(done: HalfStep) {
  if (done.half === 'local') {
    const all = done.fitted.reduce((sum, { count }) => sum + count, 0);
    const one = done.fitted.length === 1;
    const kinds = done.fitted.map(
      ({ label, count }) => `${one ? '' : `${groupDigits(count)} `}${label.toLowerCase()}`,
    );
    const fitted =
      all > 0
        ? `${groupDigits(all)} ${all === 1 ? 'shape' : 'shapes'} fitted (${kinds.join(', ')})`
        : 'nothing to fit';
    return `Local step done: ${fitted}; next: global step`;
  }
  if (done.half === 'held')
    return done.met
      ? 'Nothing moved: what is required is satisfied already, and the global step would leave it'
      : 'Nothing moved: Run found no closer shape, and the global step would leave this one';
  const where = done.accelerated ? 'beyond the' : 'to the';
  const why = done.accelerated ? ', because steps are accelerated' : '';
  const next = done.converged ? 'converged' : 'next: local step';
  return `Global step done: moved ${where} least-squares solution${why}; ${next}`;
}
