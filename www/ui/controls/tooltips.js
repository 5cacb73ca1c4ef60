/** What a button is called that shows no name, for fingers: resting on one shows its tooltip. */

import { element } from '../dom.js';

/** A finger that rests so long asks, in milliseconds. */
const REST_MS = 500;
const GAP = 6;

export function tooltipsForTouch() {
  const tip = element('div', { id: 'tooltip', role: 'tooltip', popover: 'manual' });
  document.body.append(tip);
  let timer = 0;

  /** @param {HTMLElement} control */
  function show(control) {
    tip.textContent = control.title;
    tip.showPopover();
    const { left, width, top, bottom } = control.getBoundingClientRect();
    const middle = left + width / 2 - tip.offsetWidth / 2;
    const above = top - GAP - tip.offsetHeight;
    tip.style.left = `${Math.max(GAP, Math.min(middle, innerWidth - tip.offsetWidth - GAP))}px`;
    tip.style.top = `${above > 0 ? above : bottom + GAP}px`;
  }

  const hide = () => {
    clearTimeout(timer);
    if (tip.matches(':popover-open')) tip.hidePopover();
  };
  document.addEventListener('keydown', hide);
  document.addEventListener('pointerdown', ({ pointerType, target }) => {
    hide();
    if (pointerType !== 'touch' || !(target instanceof Element)) return;
    const control = target.closest('button[title], label[title]');
    if (control instanceof HTMLElement) timer = window.setTimeout(() => show(control), REST_MS);
  });
  for (const name of ['pointerup', 'pointercancel'])
    document.addEventListener(name, () => clearTimeout(timer));
  // Who asked what it does has not pressed it. What was shown stays until the next touch.
  const leaveAlone = (/** @type {Event} */ event) => {
    if (!tip.matches(':popover-open')) return;
    event.preventDefault();
    event.stopPropagation();
  };
  document.addEventListener('click', leaveAlone, { capture: true });
  document.addEventListener('contextmenu', leaveAlone, { capture: true });
}
