/**
 * Lesson goals on the parts. The session lacks the large module that makes parts, so their numbers
 * are measured here while the shape is at rest; the session discards them when it moves.
 */

import { LiveBuild } from './live-build.js';

/** @param {import("../../app/context.js").AppContext} app */
export async function buildGoals(app) {
  const { store, actions } = app;
  const live = new LiveBuild(app, {
    show: tell,
    showOffset: () => {},
    refuse: () => actions.setBuildNumbers([]),
  });
  await live.offers();

  async function tell() {
    await actions.setBuildNumbers(await live.numbers());
  }

  const isAsked = () =>
    !store.get().running && store.get().document?.lesson?.goals.some(({ build }) => build);
  store.subscribe(['running', 'document'], () => {
    if (isAsked()) live.again();
  });
  store.subscribe(['numbers'], () => {
    if (isAsked()) live.update();
  });
  if (isAsked()) live.again();
}
