/**
 * Menus: popovers that open at their button, stay inside the window, and support the arrow keys.
 */

import { itemByKey } from './arrow-keys.ts';

const MOUSE = matchMedia('(pointer: fine)');

/** Places a popover at its button, inside the window, also when the window is resized. */
export function placeMenu(menu: HTMLElement, anchor: () => HTMLElement) {
  const place = () => {
    const at = anchor().getBoundingClientRect();
    // A menu at a point opens beside it, except for touch, where the finger would press it.
    const isPoint = at.width === 0 && MOUSE.matches;
    // Reset, so that the last position does not limit the width.
    menu.style.left = '0';
    const gap = 4;
    const left = Math.min(at.left + (isPoint ? gap : 0), innerWidth - menu.offsetWidth - 2 * gap);
    const [above, below] = [at.top - 2 * gap, innerHeight - at.bottom - 2 * gap];
    const room = isPoint ? innerHeight - 2 * gap : Math.max(above, below);
    // A menu too tall for the side with more room scrolls; at a point it moves up instead.
    menu.style.maxHeight = `${room}px`;
    const height = Math.min(menu.offsetHeight, room);
    const higher = isPoint ? innerHeight - gap - height : at.top - gap - height;
    menu.style.left = `${Math.max(2 * gap, left)}px`;
    menu.style.top = `${height <= below ? at.bottom + gap : higher}px`;
  };
  menu.addEventListener('toggle', (event) => {
    if (event.newState !== 'open') return;
    place();
    itemsOf(menu)[0]?.focus();
  });
  addEventListener('resize', () => menu.matches(':popover-open') && place());
  menu.addEventListener('keydown', (event) => {
    // Fields handle arrow keys themselves.
    const isField = event.target instanceof Element && event.target.matches('input, select');
    if (!isField) itemByKey(event, itemsOf(menu), { along: 'y' })?.focus();
  });
}

/** Returns the items that the arrow keys move between. */
function itemsOf(menu: HTMLElement) {
  const items = menu.querySelectorAll<HTMLElement>('a, button, [role="menuitem"]');
  return [...items].filter((item) => item.checkVisibility() && !item.matches(':disabled'));
}
