/**
 * Goals on what is built of the shape. The module of parts is large, and the session does without it: while the shape
 * is at rest the numbers are measured here, and told to the session, which forgets them when the shape moves.
 */

import { LiveBuild } from './live-build.js';

/** @param {import("../../app/context.js").AppContext} app */
export async function buildGoals(app) {
  const { store, actions } = app;
  const live = new LiveBuild(app, {
    show: tell,
    showOffset: () => {},
    refuse: () => actions.tellBuild([]),
  });
  await live.offers();

  async function tell() {
    await actions.tellBuild(await live.numbers());
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
