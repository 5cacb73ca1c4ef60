/** Walking through items with the arrow keys, as toolbars, menus, tabs and lists do. */

const KEYS = {
  x: { ArrowRight: 1, ArrowLeft: -1 },
  y: { ArrowDown: 1, ArrowUp: -1 },
};

/**
 * The item that a key leads to from the one with the focus; the page does nothing else with the key then.
 * @template {HTMLElement} Item
 * @param {KeyboardEvent} event
 * @param {Item[]} items
 * @param {{ along: "x" | "y", wraps?: boolean, ends?: boolean }} options `wraps`: from the last to the first;
 *   `ends`: Home and End lead there
 * @returns {Item | undefined} none where the key leads nowhere
 */
export function itemByKey(event, items, { along, wraps = true, ends = false }) {
  const last = items.length - 1;
  const end = ends ? { Home: 0, End: last }[event.key] : undefined;
  /** @type {Record<string, number>} */
  const steps = KEYS[along];
  const step = steps[event.key];
  if (last < 0 || (end === undefined && step === undefined)) return undefined;
  event.preventDefault();
  const at = items.findIndex((item) => item === document.activeElement);
  const next = end ?? (at < 0 && step < 0 ? last : at + step);
  return items[wraps ? (next + items.length) % items.length : Math.max(0, Math.min(next, last))];
}
