/** Shows a place that may be inside something closed. */

/** The event of a step in which something is revealed; a narrow window shows that step. */
export const REVEALED = 'revealed';

/** Opens what is closed around a place, and scrolls it into view. */
export function reveal(place: HTMLElement) {
  let around: Element | null = place;
  while ((around = around.closest('details'))) {
    if (around instanceof HTMLDetailsElement) around.open = true;
    around = around.parentElement;
    if (!around) break;
  }
  place.dispatchEvent(new CustomEvent(REVEALED, { bubbles: true }));
  place.scrollIntoView({ block: 'nearest' });
}
