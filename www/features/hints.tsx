/**
 * The hints of the first visit, in the card with the purpose of the page, which is in index.html:
 * following one leads to the next. Shown once, and only over the example, which is solved on
 * opening. What it says of the panels is updated continuously, also during a drag.
 */

import { useSignal, useSignalEffect } from '@preact/signals';
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { declared, isInLegend, worstOf } from '../store/colours/measures.ts';
import { useApp } from '../store/use-app.ts';
import { CloseButton } from '../ui/components/buttons.tsx';
import { useThrottled } from '../ui/components/use-throttled.ts';
import { byId } from '../ui/dom.ts';
import { getItem, setItem } from '../ui/safe-storage.ts';
import { hasMoved, type State } from '../store/state.ts';

const KEY = 'shape-up.hints';
const START = 'This is the original. Press Run.';

/** @param now statement that holds for every panel */
const hints = (now: string) => [
  `${now} Drag a blue handle: the shape is solved again as you drag.`,
  'Press Reset to go back to the original. Undo brings your shape back.',
  'Your turn: open a mesh of your own, or try another example.',
];

export function FirstHints() {
  // index.html hides the card in this case.
  const [wasDone] = useState(() => getItem(KEY) === 'done');
  return wasDone ? null : <Hints />;
}

function Hints() {
  const { state } = useApp().store;
  const { at, isDone, finish } = useProgress();
  const words = useThrottled(() => (isDone.value ? '' : hintOf(state, at.value)));
  const { firstExample, fileName, nothingOpen } = state;
  const isOfOther = fileName !== '' && !firstExample;
  const isHidden = isDone.value || nothingOpen || isOfOther;
  const isSaid = words !== '' && !isHidden;
  useLayoutEffect(() => {
    byId('hint-card').hidden = isHidden;
    // The card was hidden because other work was expected.
    if (isSaid) delete document.documentElement.dataset.known;
  }, [isHidden, isSaid]);
  return (
    <>
      <p class="said">{words}</p>
      <CloseButton label="Dismiss hint" onClick={finish} />
    </>
  );
}

/** Returns the hint in words; empty before there is anything to say. */
function hintOf(state: Readonly<State>, at: number) {
  const { document, numbers, firstExample, renderer } = state;
  // Hints are about what can be dragged in the view.
  if (renderer === 'none') return '';
  const about = declared(state, document?.measure ?? null);
  if (!document || !numbers || !about || !firstExample) return '';
  const met =
    worstOf(state, about.id) === 0
      ? `${about.met[0].toUpperCase()}${about.met.slice(1)}, exactly.`
      : `Wanted: ${about.met}.${state.display.legend && isInLegend(state, about.id) ? ' The legend shows how far off the panels are.' : ''}`;
  return !hasMoved(numbers) && at < 2 ? START : hints(met)[at];
}

/** The number of hints that were followed, and whether they are done with. */
function useProgress() {
  const { state } = useApp().store;
  const at = useSignal(0);
  const isDone = useSignal(false);
  /** What has been seen of the user's actions. */
  const seen = useRef({ at: 0, drags: false, isStart: false, runs: false, hasRun: false });

  function finish() {
    isDone.value = true;
    setItem(KEY, 'done');
  }

  useSignalEffect(() => {
    const { firstExample, document, numbers, running, dragged } = state;
    const now = seen.current;
    if (!firstExample) {
      if (now.at > 0) finish();
      return;
    }
    if (!document || !numbers) return;
    if (now.drags && dragged.length === 0) now.at = Math.max(now.at, 1);
    if (now.runs && !running) now.hasRun = true;
    now.drags = dragged.length > 0;
    // A run from the unsolved start; its first iterations may be seen together with it.
    now.runs = running && (now.runs || now.isStart);
    now.isStart = !hasMoved(numbers);
    if (now.at === 1 && now.hasRun) now.at = 2;
    // The hints are done once the last one is shown.
    if (now.at === 2) setItem(KEY, 'done');
    at.value = now.at;
  });

  return { at, isDone, finish };
}
