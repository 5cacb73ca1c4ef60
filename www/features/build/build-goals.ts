/**
 * Lesson goals on the parts. Their numbers are measured in the second worker, so that iterations
 * do not wait, while the shape is at rest; the session discards them when it moves.
 */

import { LiveBuild } from './live-build.ts';
import type { AppContext } from '../../app/context.ts';

export async function buildGoals(app: AppContext) {
  const { store, actions } = app;
  const live = new LiveBuild(app, 'goals', {
    show: () => void actions.reportErrors(tell()),
    showOffset: () => {},
    refuse: () => void actions.reportErrors(actions.setBuildNumbers([])),
  });
  await live.offers();

  async function tell() {
    const numbers = await live.numbers();
    // Of another shape they say nothing; it is built in its turn.
    if (live.isCurrent()) await actions.setBuildNumbers(numbers);
  }

  const isAsked = () =>
    !store.get().running && store.get().document?.lesson?.goals.some(({ build }) => build);
  store.subscribe(['running', 'document'], () => {
    if (isAsked()) void live.again();
  });
  store.subscribe(['numbers'], () => {
    if (isAsked()) void live.update();
  });
  if (isAsked()) void live.again();
}
