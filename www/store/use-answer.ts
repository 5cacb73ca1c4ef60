/** Answers of the worker that a component shows. */

import { useSignal, useSignalEffect } from '@preact/signals';
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { throttled } from '../ui/dom.ts';
import { newestOnly } from './latest-only.ts';
import { useApp } from './use-app.ts';
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
 * Asks again whenever the model or what `follow` reads changes, at most every `interval` milliseconds,
 * and only while the element is in sight.
 * @param follow reads what the answer depends on
 * @param ask resolves with undefined if there is no answer
 * @returns the last answer; null before the first one on this model: elements of another one mean
 *   nothing here
 */
export function useAnswer<Answer>(
  place: RefObject<Element | null>,
  interval: number,
  follow: () => unknown,
  ask: () => Promise<Answer | undefined> | undefined,
): Answer | null {
  const { store } = useApp();
  const answer = useSignal<{ model: unknown; found: Answer } | null>(null);
  const isInView = useInView(place);
  const latest = useRef(ask);
  latest.current = ask;
  const askSoon = useMemo(() => {
    const newest = newestOnly(() => store.get().model);
    return throttled(interval, async () => {
      const { model } = store.get();
      const found = model && isInView.peek() ? await newest(latest.current()) : undefined;
      if (found !== undefined) answer.value = { model, found };
    });
  }, []);
  const followed = useRef(follow);
  followed.current = follow;
  useSignalEffect(() => {
    followed.current();
    if (store.state.model && isInView.value) askSoon();
  });
  return answer.value?.model === store.state.model ? (answer.value?.found ?? null) : null;
}

/**
 * Asks at first and whenever the question changes. Of the answers to earlier questions none is shown that
 * comes late, and no error is reported.
 * @param question what the answer depends on, each compared by identity
 * @param ask resolves with undefined if there is no answer
 * @returns the latest answer, undefined before the first one, and whether it is that to `question`
 */
export function useAnswerTo<Answer>(
  question: unknown[],
  ask: () => Promise<Answer | undefined> | undefined,
): { answer: Answer | undefined; isCurrent: boolean } {
  const { actions } = useApp();
  const newest = useMemo(() => newestOnly(), []);
  const [known, setKnown] = useState<{ of: unknown[]; answer: Answer } | null>(null);
  useEffect(() => {
    void actions.reportErrors(newest(ask())).then((answer) => {
      if (answer !== undefined) setKnown({ of: question, answer });
    });
  }, question);
  const isCurrent = known !== null && question.every((part, i) => part === known.of[i]);
  return { answer: known?.answer, isCurrent };
}
