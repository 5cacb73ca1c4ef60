/**
 * Toolbars as one tab stop each: the arrow keys move within them, Home and End to their ends, and
 * the tab stop is the control that last had the focus.
 */

import { itemByKey } from './arrow-keys.ts';

const CONTROLS = 'button, input, select';

/** @param bar with `role="toolbar"` */
export function oneTabStop(bar: HTMLElement) {
  let stop: HTMLElement | null = null;
  const all = () => [...bar.querySelectorAll(CONTROLS)] as HTMLButtonElement[];
  const reachable = () => all().filter((control) => !control.disabled && control.checkVisibility());

  function update() {
    const controls = reachable();
    const focused = controls.find((control) => control === document.activeElement);
    const last = controls.find((control) => control === stop);
    stop = focused ?? last ?? controls[0] ?? null;
    for (const control of all()) control.tabIndex = control === stop ? 0 : -1;
  }

  bar.addEventListener('focusin', update);
  bar.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) return;
    // On a slider, Home and End change its value.
    const ends = !(event.target instanceof Element && event.target.matches('[type="range"]'));
    itemByKey(event, reachable(), { along: 'x', ends })?.focus();
  });
  // The control with the tab stop may disappear or reappear.
  const watch = { subtree: true, childList: true, attributeFilter: ['disabled', 'hidden'] };
  new MutationObserver(update).observe(bar, watch);
  new ResizeObserver(update).observe(bar);
  update();
}
