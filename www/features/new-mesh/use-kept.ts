/** What was chosen in a form that is left for the form of another shape. */

import { useState } from 'preact/hooks';

/** The choices of each form, by the shape, as long as the dialog is open. */
export type Kept = Map<string, unknown>;

/**
 * As `useState`, but what is set is there again when the form comes back.
 * @param first makes what is there at first
 */
export function useKept<Chosen>(
  kept: Kept,
  id: string,
  first: () => Chosen,
): [Chosen, (next: Chosen) => void] {
  const [chosen, set] = useState(() => (kept.has(id) ? (kept.get(id) as Chosen) : first()));
  kept.set(id, chosen);
  return [chosen, set];
}
