/** Navigation among items with the arrow keys, for toolbars, menus, tabs and lists. */

const KEYS = {
  x: { ArrowRight: 1, ArrowLeft: -1 },
  y: { ArrowDown: 1, ArrowUp: -1 },
};

/**
 * Returns the item that a key moves the focus to, and prevents the default action of the key.
 * @param options `wraps`: from the last to
 *   the first; `ends`: Home and End move to the ends
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
