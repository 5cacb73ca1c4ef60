/** Toggle between the two halves of an iteration (Fig. 4 of the paper). */

import type { Store } from '../state.ts';

export function halfStepTitle({ halfway }: { halfway: boolean }) {
  return halfway
    ? 'Global step: move all vertices to the least-squares solution'
    : 'Local step: fit a shape to each constraint; nothing moves yet';
}

/** The switches in the toolbar and in the phone's menu are on between the two halves. */
export function bindHalfStepSwitches(store: Store) {
  const switches = [...document.querySelectorAll('[data-command="half-step"]')];
  store.subscribe(['halfway'], ({ halfway }) => {
    for (const one of switches) {
      one.setAttribute('aria-checked', String(halfway));
      one.querySelector('use')?.setAttribute('href', halfway ? '#icon-global' : '#icon-local');
    }
  });
}
