/** Elements that cover the view, beside which the model is framed. */

import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { useApp } from '../store/use-app.ts';
import { cover, narrow, uncover } from './camera.ts';

/**
 * @param edge that the element lies along, if any
 * @param told the height that it covers, in CSS pixels
 * @param of what covers the view, if the element is a part of it
 * @returns the reference of the element
 */
export function useCover<Kind extends HTMLElement>(
  edge: 'top' | 'bottom' | null = 'bottom',
  told: (covered: number) => void = () => {},
  of: (part: Kind) => HTMLElement = (part) => part,
) {
  const { viewport } = useApp();
  const place = useRef<Kind>(null);
  useLayoutEffect(() => {
    if (!place.current) return;
    const element = of(place.current);
    const renew = () => told(cover(viewport, element, edge));
    renew();
    // A view that is there later, or again, knows of nothing that covers it.
    const stop = viewport.on('ready', renew);
    const size = new ResizeObserver(renew);
    size.observe(element);
    return () => {
      stop();
      size.disconnect();
      uncover(viewport, element);
      told(0);
    };
  }, [viewport, edge]);
  return place;
}

/** Whether the window is one in which messages and cards lie below the model. */
export function useNarrow() {
  const [isNarrow, setNarrow] = useState(narrow.matches);
  useEffect(() => {
    const follow = () => setNarrow(narrow.matches);
    narrow.addEventListener('change', follow);
    return () => narrow.removeEventListener('change', follow);
  }, []);
  return isNarrow;
}
