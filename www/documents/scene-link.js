/** The address that opens the scene as it is now. */

import { writeLink } from './share-link.js';

/** @param {Pick<import("../app/context.js").AppContext, "store" | "actions" | "files">} app */
export async function linkTo({ store, actions, files }) {
  const text = await actions.sceneText();
  const { numbers } = store.get();
  const { example } = files.origin;
  const { variants, current } = JSON.parse(text);
  // A design that was kept is as exact as it was.
  const isKept = variants?.design !== undefined && !current;
  const run = (numbers?.iteration ?? 0) > 0 && !isKept;
  const fragment = await writeLink(text, example, files.original, run);
  return new URL(fragment, location.href.split('#')[0]).href;
}
