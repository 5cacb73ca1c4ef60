/** Presenting: the model full screen, with the title and text of each step in large type. */

import './present.css';
import { button } from '../../ui/controls/fields.ts';
import { byId, element, setText } from '../../ui/dom.ts';
import { presentActions } from '../../store/present-actions.ts';
import type { AppContext } from '../../app/context.ts';
import type { Slide } from '../../solver/types.ts';

const { dataset } = document.documentElement;

/** Actions of keys, including presenter remotes. */
const KEYS: Record<string, 'next' | 'previous' | 'first' | 'last' | 'dark' | 'run' | 'end'> = {
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
  ' ': 'run',
  Escape: 'end',
};

/** If full screen is refused, as in some frames, the presentation fills the window. */
async function fillScreen() {
  if (document.fullscreenElement) return;
  await document.documentElement.requestFullscreen?.().catch(() => {});
}

/** @param withNotes in a window of their own */
export async function present(app: AppContext, withNotes: boolean) {
  const notes = withNotes ? openNotes(press) : null;
  if (withNotes && !notes)
    throw new Error('The browser blocked the window for the notes: allow pop-ups for this page.');
  const { store, actions } = app;
  const slides = presentActions(store, actions);
  const title = element('h2');
  const text = element('p');
  const place = element('span', { 'aria-live': 'polite' });
  const previous = button('Previous', () => go(at - 1));
  const next = button('Next', forward, { class: 'primary' });
  const stage = element(
    'section',
    { id: 'stage', 'aria-label': 'Presentation' },
    element('div.said', title, text),
    element('div.stage-bar', previous, place, next, button('End', end)),
  );
  let at = 0;
  const steps = () => store.get().document?.steps ?? [];

  async function go(to: number) {
    const all = steps();
    at = Math.min(Math.max(to, 0), all.length - 1);
    if (at < 0) return end();
    stage.removeAttribute('data-dark');
    const { title: heading, text: words = '' } = all[at];
    setText(title, heading);
    setText(text, words);
    text.hidden = words === '';
    setText(place, `${at + 1} of ${all.length}`);
    previous.disabled = at === 0;
    next.disabled = at === all.length - 1;
    notes?.show(all[at], all[at + 1], place.textContent ?? '');
    await slides.showStep(at);
  }

  /** Shows the next step. Opening the notes window ends full screen, so this enters it again. */
  function forward() {
    if (notes) void fillScreen();
    return go(at + 1);
  }

  const done = {
    next: forward,
    previous: () => go(at - 1),
    first: () => go(0),
    last: () => go(steps().length - 1),
    dark: () => stage.toggleAttribute('data-dark'),
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
    void done[what]();
  }

  function leftScreen() {
    if (!document.fullscreenElement) end();
  }

  function end() {
    if (!stage.isConnected) return;
    removeEventListener('keydown', press, true);
    document.removeEventListener('fullscreenchange', leftScreen);
    delete dataset.presenting;
    actions.look({ presenting: false });
    stage.remove();
    notes?.close();
    if (document.fullscreenElement) document.exitFullscreen().catch(() => {});
    actions.setStatus('The presentation has ended');
  }

  dataset.presenting = '';
  actions.look({ presenting: true });
  byId('main').append(stage);
  addEventListener('keydown', press, true);
  document.addEventListener('fullscreenchange', leftScreen);
  if (!notes) await fillScreen();
  next.focus();
  await go(0);
}

/**
 * Opens the window of the speaker's notes beside the page. Keys pressed in it are passed to `press`.
 * @returns null if the browser blocks the window
 */
function openNotes(press: (event: KeyboardEvent) => void): {
  show: (step: Slide, next: Slide | undefined, place: string) => void;
  close: () => void;
} | null {
  const beside = open('', 'shape-up-notes', 'popup,width=560,height=480');
  if (!beside) return null;
  const { document: page } = beside;
  page.title = 'Presentation notes';
  page.documentElement.dataset.theme = document.documentElement.dataset.theme ?? '';
  const styles = document.querySelectorAll('link[rel="stylesheet"], style');
  page.head.replaceChildren(...[...styles].map((style) => page.importNode(style, true)));
  const place = element('p.quiet');
  const title = element('h1');
  const notes = element('p.notes');
  const after = element('p.quiet');
  page.body.replaceChildren(element('main.notes-window', place, title, notes, after));
  beside.addEventListener('keydown', press);
  return {
    show(step, next, words) {
      setText(place, words);
      setText(title, step.title);
      setText(notes, step.notes || 'No notes for this step.');
      setText(after, next ? `Next: ${next.title}` : 'This is the last step.');
    },
    close: () => beside.close(),
  };
}
