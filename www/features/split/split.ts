/**
 * Opens and closes the split view: two pictures of the model, left and right of a divider. Its
 * controls are loaded with `split-view.ts` on first use.
 */

import type { Choice } from '../../store/view-modes.ts';
import type { AppContext } from '../../app/context.ts';

/** Toggles the split view, which opens with the choices made last. */
export function toggleSplit(app: AppContext) {
  if (app.store.get().split) app.actions.look({ split: null, status: 'Split view closed' });
  else void splitInto(app);
}

/**
 * Shows two pictures.
 * @param choices left and right
 */
export async function splitInto(app: AppContext, choices?: [Choice, Choice]) {
  const view = import('./split-view.ts').then((it) => it.SplitView.of(app).open(choices));
  await app.actions.reportErrors(view);
}
