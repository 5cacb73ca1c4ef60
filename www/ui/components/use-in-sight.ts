/** What is chosen, kept in sight within a list that scrolls. */

import { useEffect, useRef } from 'preact/hooks';

/** Returns the reference of an element that is scrolled into view when it becomes chosen. */
export function useInSight<Kind extends Element>(isChosen: boolean) {
  const place = useRef<Kind>(null);
  useEffect(() => {
    if (isChosen) place.current?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  }, [isChosen]);
  return place;
}
