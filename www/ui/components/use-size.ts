/** The size of an element. */

import { useLayoutEffect, useState } from 'preact/hooks';
import type { RefObject } from 'preact';

/** Returns width and height in pixels, without borders; zeros while the element is not in the page. */
export function useSize(place: RefObject<Element | null>) {
  const [size, setSize] = useState<[number, number]>([0, 0]);
  useLayoutEffect(() => {
    const { current } = place;
    if (!current) return undefined;
    const measure = () => setSize([current.clientWidth, current.clientHeight]);
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(current);
    return () => observer.disconnect();
  }, []);
  return size;
}
