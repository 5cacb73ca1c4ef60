/** Navigation among items with the arrow keys, and what has it: toolbars and menus. */

const KEYS = {
  x: { ArrowRight: 1, ArrowLeft: -1 },
  y: { ArrowDown: 1, ArrowUp: -1 },
};

/**
 * Returns the item that a key moves the focus to, and prevents the default action of the key.
 * @param options `wraps`: from the last to the first; `ends`: Home and End move to the ends
 * @returns undefined for other keys
 */
export function itemByKey<Item extends HTMLElement>(
  event: KeyboardEvent,
  items: Item[],
  { along, wraps = true, ends = false }: { along: 'x' | 'y'; wraps?: boolean; ends?: boolean },
): Item | undefined {
  const last = items.length - 1;
  const end = ends ? { Home: 0, End: last }[event.key] : undefined;
  const steps: Record<string, number> = KEYS[along];
  const step = steps[event.key];
  if (last < 0 || (end === undefined && step === undefined)) return undefined;
  event.preventDefault();
  const at = items.findIndex((item) => item === document.activeElement);
  const next = end ?? (at < 0 && step < 0 ? last : at + step);
  return items[wraps ? (next + items.length) % items.length : Math.max(0, Math.min(next, last))];
}

const CONTROLS = 'button, input, select';

/**
 * Makes a toolbar one tab stop: the arrow keys move within it, Home and End to its ends, and the tab stop
 * is the control that last had the focus.
 * @param bar with `role="toolbar"`
 */
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

const MOUSE = matchMedia('(pointer: fine)');

/**
 * Makes a popover a menu: it opens at its button, inside the window, also when the window is resized, and
 * supports the arrow keys.
 */
export function placeMenu(menu: HTMLElement, anchor: () => Pick<Element, 'getBoundingClientRect'>) {
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
