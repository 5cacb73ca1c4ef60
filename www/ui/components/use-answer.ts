/** Answers of the worker that are shown only while somebody can see them. */

import { useSignal, useSignalEffect } from '@preact/signals';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import { throttled } from '../dom.ts';
import type { RefObject } from 'preact';

/** Returns whether an element is in sight, as a signal. */
function useInView(place: RefObject<Element | null>) {
  const isInView = useSignal(false);
  useEffect(() => {
    if (!place.current) return undefined;
    const observer = new IntersectionObserver((entries) => {
      isInView.value = entries.at(-1)?.isIntersecting ?? false;
    });
    observer.observe(place.current);
    return () => observer.disconnect();
  }, []);
  return isInView;
}

/**
 * Asks again whenever what `follow` reads changes, at most every `interval` milliseconds, and only
 * while the element is in sight.
 * @param follow reads what the answer depends on
 * @param ask resolves with undefined if the answer is out of date
 * @returns the last answer; null before the first one
 */
export function useAnswer<Answer>(
  place: RefObject<Element | null>,
  interval: number,
  follow: () => unknown,
  ask: () => Promise<Answer | undefined>,
): Answer | null {
  const answer = useSignal<Answer | null>(null);
  const isInView = useInView(place);
  const latest = useRef(ask);
  latest.current = ask;
  const askSoon = useMemo(
    () =>
      throttled(interval, async () => {
        const found = isInView.peek() ? await latest.current() : undefined;
        if (found !== undefined) answer.value = found;
      }),
    [],
  );
  const followed = useRef(follow);
  followed.current = follow;
  useSignalEffect(() => {
    followed.current();
    if (isInView.value) askSoon();
  });
  return answer.value;
}
