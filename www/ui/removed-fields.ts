/** Fields that are removed while something is typed in them. */

import { options, type VNode } from 'preact';

/**
 * Keeps browsers from reporting such input: it was not entered, and what it was meant for is gone, as the
 * model before.
 */
export function dropRemovedInput() {
  const removed: WeakSet<EventTarget> = new WeakSet();
  const { unmount } = options;
  options.unmount = (vnode: VNode & { __e?: EventTarget | null }) => {
    unmount?.(vnode);
    const isField = vnode.type === 'input' || vnode.type === 'textarea';
    // The element of a node, by the name that it has in all builds of Preact.
    if (isField && vnode.__e) removed.add(vnode.__e);
  };
  // They are reported while the field is removed.
  for (const type of ['change', 'blur']) {
    const stop = (event: Event) => {
      if (event.target && removed.has(event.target)) event.stopImmediatePropagation();
    };
    document.addEventListener(type, stop, true);
  }
}
