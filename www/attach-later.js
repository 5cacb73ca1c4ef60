/** Parts of the page that few models need: they come with the first that does. */

import { messageOf } from './messages.js';

/** @param {import("./analysis.js").Parts} parts */
export function attachLater(parts) {
  const { store, files, alerts } = parts;
  const failed = (/** @type {unknown} */ error) => alerts.error(messageOf(error));

  const watch = () =>
    import('./lists/conditions.js').then(({ watchConditions }) => watchConditions(parts), failed);
  files.addEventListener('opened', watch, { once: true });

  if (matchMedia('(any-pointer: coarse)').matches)
    import('./tooltips.js').then(({ tooltipsForTouch }) => tooltipsForTouch(), failed);

  let taught = false;
  store.subscribe(['document'], ({ document }) => {
    if (taught || !document?.lesson) return;
    taught = true;
    import('./lesson/panel.js').then(({ lessonPanel }) => lessonPanel(parts), failed);
  });
}
