/** The presenter's window: the notes of the current step and the title of the next one. */

import { element, setText } from '../../ui/dom.ts';
import type { Slide } from '../../solver/types.ts';

/**
 * Opens the window beside the page. Keys pressed in it are passed to `press`.
 * @returns null if the browser blocks the window
 */
export function openNotes(press: (event: KeyboardEvent) => void): {
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
