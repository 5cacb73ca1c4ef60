/** What is chosen, kept in sight within a list that scrolls. */

import { useEffect, useRef } from 'preact/hooks';

/**
 * Returns the reference of an element that is scrolled into view when it becomes chosen.
 * @param chosen whether it is, or what in it is; falsy for nothing
 */
export function useInSight<Kind extends Element>(chosen: boolean | string) {
  const place = useRef<Kind>(null);
  useEffect(() => {
    if (chosen) place.current?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  }, [chosen]);
  return place;
}
