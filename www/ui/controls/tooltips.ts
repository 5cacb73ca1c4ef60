/** Tooltips for touch and keyboard: a long press or the focus on a control shows its title. */

import { byId, element } from '../dom.ts';

/** How long a finger or the focus must rest, in milliseconds. */
const REST_MS = 500;
const GAP = 6;
const WITH_TOOLTIP = 'button[title], label[title]';

export function tooltips() {
  const tip = element('div', { id: 'tooltip', role: 'tooltip', popover: 'manual' });
  // Within a landmark, as all that is read.
  byId('main').append(tip);
  let timer = 0;

  function show(control: HTMLElement) {
    tip.textContent = control.title;
    tip.showPopover();
    const { left, width, top, bottom } = control.getBoundingClientRect();
    const middle = left + width / 2 - tip.offsetWidth / 2;
    const above = top - GAP - tip.offsetHeight;
    tip.style.left = `${Math.max(GAP, Math.min(middle, innerWidth - tip.offsetWidth - GAP))}px`;
    tip.style.top = `${above > 0 ? above : bottom + GAP}px`;
  }

  function showLater(target: Element) {
    const control = target.closest(WITH_TOOLTIP);
    if (control instanceof HTMLElement) timer = window.setTimeout(() => show(control), REST_MS);
  }

  const hide = () => {
    clearTimeout(timer);
    if (tip.matches(':popover-open')) tip.hidePopover();
  };
  // Not `:focus-visible`, which also matches clicked fields.
  let byKey = false;
  // Captured, to run before the key moves the focus.
  const keyDown = () => {
    hide();
    byKey = true;
  };
  document.addEventListener('keydown', keyDown, { capture: true });
  document.addEventListener('pointerdown', ({ pointerType, target }) => {
    hide();
    byKey = false;
    if (pointerType !== 'touch' || !(target instanceof Element)) return;
    showLater(target);
  });
  document.addEventListener('focusin', ({ target }) => {
    if (byKey && target instanceof Element) showLater(target);
  });
  document.addEventListener('focusout', () => {
    if (byKey) hide();
  });
  for (const name of ['pointerup', 'pointercancel'])
    document.addEventListener(name, () => clearTimeout(timer));
  // A long press must not also click. The tooltip stays until the next touch.
  const leaveAlone = (event: Event) => {
    if (byKey || !tip.matches(':popover-open')) return;
    event.preventDefault();
    event.stopPropagation();
  };
  document.addEventListener('click', leaveAlone, { capture: true });
  document.addEventListener('contextmenu', leaveAlone, { capture: true });
}
