/** Presenting: the model full screen, with the title and text of each step in large type. */

import './present.css';
import { useComputed, useSignal } from '@preact/signals';
import { useLayoutEffect, useMemo, useRef } from 'preact/hooks';
import { presentActions } from '../../store/present-actions.ts';
import { useApp } from '../../store/use-app.ts';
import { Button } from '../../ui/components/buttons.tsx';
import type { Slide } from '../../pkg/engine/shape_up.js';

/** Actions of keys, including presenter remotes. */
const KEYS: Record<
  string,
  'next' | 'previous' | 'first' | 'last' | 'dark' | 'title' | 'run' | 'end'
> = {
  ArrowRight: 'next',
  ArrowDown: 'next',
  PageDown: 'next',
  n: 'next',
  ArrowLeft: 'previous',
  ArrowUp: 'previous',
  PageUp: 'previous',
  p: 'previous',
  Home: 'first',
  End: 'last',
  b: 'dark',
  '.': 'dark',
  t: 'title',
  ' ': 'run',
  Escape: 'end',
};

/** The presentation, if there is one. */
export function Stage() {
  return useApp().store.state.presenting ? <Presentation /> : null;
}

function Presentation() {
  const { store, actions } = useApp();
  const slides = useMemo(() => presentActions(store, actions), []);
  const asked = useSignal(0);
  /** Those of the last document: there is none while a mesh is replaced or restored. */
  const known = useRef<Slide[]>([]);
  const stepsNow = () => (known.current = store.state.document?.steps ?? known.current);
  /** Undo may remove steps. */
  const at = useComputed(() => Math.max(Math.min(asked.value, stepsNow().length - 1), 0));
  const isDark = useSignal(false);
  /** Whether the title and the text lie over the view. */
  const isTitled = useSignal(true);
  const nextButton = useRef<HTMLButtonElement>(null);
  const steps = stepsNow();
  const step: Slide | undefined = steps[at.value];
  const place = `${at.value + 1} of ${steps.length}`;

  async function go(to: number) {
    const { document } = store.get();
    if (!document) return;
    asked.value = Math.min(Math.max(to, 0), document.steps.length - 1);
    isDark.value = false;
    await slides.showStep(at.value);
  }

  function end() {
    actions.look({ presenting: false });
    actions.setStatus('The presentation has ended');
  }

  const done = {
    next: () => go(at.value + 1),
    previous: () => go(at.value - 1),
    first: () => go(0),
    last: () => go(Infinity),
    dark: () => {
      isDark.value = !isDark.value;
    },
    title: () => {
      isTitled.value = !isTitled.value;
    },
    run: () => actions.runOrPause(),
    end,
  };

  function press(event: KeyboardEvent) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    // A dialog over it has its own keys.
    if (document.querySelector('dialog:modal')) return;
    // Presenter remotes send F5; it must not reload the page.
    if (event.key === 'F5') return event.preventDefault();
    const what = KEYS[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!what) return;
    event.preventDefault();
    event.stopPropagation();
    const isHeld = event.repeat && ['dark', 'title', 'run'].includes(what);
    if (!isHeld) void done[what]();
  }

  const isOver = store.state.document !== null && steps.length === 0;
  useLayoutEffect(() => {
    if (isOver) end();
  }, [isOver]);

  useLayoutEffect(() => {
    const leftScreen = () => {
      if (!document.fullscreenElement) end();
    };
    addEventListener('keydown', press, true);
    document.addEventListener('fullscreenchange', leftScreen);
    void fillScreen();
    nextButton.current?.focus();
    void go(0);
    return () => {
      removeEventListener('keydown', press, true);
      document.removeEventListener('fullscreenchange', leftScreen);
      if (document.fullscreenElement) document.exitFullscreen().catch(() => {});
    };
  }, []);

  return (
    <section id="stage" aria-label="Presentation" data-dark={isDark.value ? '' : undefined}>
      <div class="said" hidden={!isTitled.value}>
        <h2>{step?.title}</h2>
        {step?.text && <p>{step.text}</p>}
      </div>
      <div class="stage-bar">
        <Button disabled={at.value === 0} onClick={done.previous}>
          Previous
        </Button>
        <span aria-live="polite">{place}</span>
        <button
          ref={nextButton}
          type="button"
          class="primary"
          disabled={at.value === steps.length - 1}
          onClick={done.next}
        >
          Next
        </button>
        <Button
          title="Show or hide the title (T)"
          aria-pressed={isTitled.value}
          onClick={done.title}
        >
          Title
        </Button>
        <Button onClick={end}>End</Button>
      </div>
    </section>
  );
}

/** If full screen is refused, as in some frames, the presentation fills the window. */
async function fillScreen() {
  if (document.fullscreenElement) return;
  await document.documentElement.requestFullscreen?.().catch(() => {});
}
