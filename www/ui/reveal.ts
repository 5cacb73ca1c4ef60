/** Shows a place that may be inside something closed. */

/** The event of a step in which something is revealed; a narrow window shows that step. */
export const REVEALED = 'revealed';

/** Opens what is closed around a place, and scrolls it into view. */
export function reveal(place: HTMLElement) {
  let around = place.closest('details');
  while (around) {
    around.open = true;
    around = around.parentElement?.closest('details') ?? null;
  }
  place.dispatchEvent(new CustomEvent(REVEALED, { bubbles: true }));
  place.scrollIntoView({ block: 'nearest' });
}
