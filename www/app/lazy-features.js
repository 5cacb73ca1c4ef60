/** Parts of the page that few models need: they come with the first that does. */

import { messageOf } from '../solver/messages.js';

/** @param {import("./context.js").AppContext} parts */
export function attachLater(parts) {
  const { store, solver, files, alerts } = parts;
  const failed = (/** @type {unknown} */ error) => alerts.error(messageOf(error));

  const watch = () =>
    import('../features/warnings.js').then(({ watchConditions }) => watchConditions(parts), failed);
  files.once('opened', watch);
  const offer = () =>
    import('../features/make-panels/card.js').then(
      ({ MakePanels }) => void new MakePanels(parts),
      failed,
    );
  files.once('opened', offer);
  solver.on('collapsed', ({ collapse }) => {
    import('../documents/collapse.js').then(
      ({ tellCollapse }) => tellCollapse(parts, collapse),
      failed,
    );
  });

  let watched = false;
  store.subscribe(['document'], ({ document }) => {
    if (watched || !document?.free || document.constraints.length === 0) return;
    watched = true;
    import('../features/free-vertices.js').then(
      ({ watchFreeVertices }) => watchFreeVertices(parts),
      failed,
    );
  });

  if (matchMedia('(any-pointer: coarse)').matches)
    import('../ui/controls/tooltips.js').then(({ tooltipsForTouch }) => tooltipsForTouch(), failed);

  let taught = false;
  store.subscribe(['document'], ({ document }) => {
    if (taught || !document?.lesson) return;
    taught = true;
    import('../features/lesson/panel.js').then(({ lessonPanel }) => lessonPanel(parts), failed);
  });
}
