/** Fields that are removed while something is typed in them. */

import { options } from 'preact';

/**
 * Keeps browsers from reporting such input: it was not entered, and what it was meant for is gone, as the
 * model before.
 */
export function dropRemovedInput() {
  let isRemoving = false;
  const { unmount } = options;
  options.unmount = (vnode) => {
    unmount?.(vnode);
    if (isRemoving) return;
    isRemoving = true;
    queueMicrotask(() => {
      isRemoving = false;
    });
  };
  // They are reported while the field is removed.
  for (const type of ['change', 'blur']) {
    const stop = (event: Event) => {
      const isField = event.target instanceof Element && event.target.matches('input, textarea');
      if (isRemoving && isField) event.stopImmediatePropagation();
    };
    document.addEventListener(type, stop, true);
  }
}
