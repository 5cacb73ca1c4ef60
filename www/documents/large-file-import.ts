/**
 * Opening of large files: a progress display, a cancel button, and a question before a mesh that is
 * too large for interactive work is loaded.
 */

import '../ui/styles/waiting.css';
import { button } from '../ui/controls/fields.ts';
import { byId, element, removeKeepingFocus, setText } from '../ui/dom.ts';
import { groupDigits, megabytes } from '../ui/words.ts';
import { Cancelled, messageOf, unreadable } from '../solver/errors.ts';
import { faceCountOf } from './face-count.ts';
import type { NamedBytes, Opened } from '../solver/types.ts';
import type { Actions } from '../store/actions.ts';
import type { Alerts } from '../ui/controls/alerts.ts';

/**
 * Opens files as `Files.open` does, with a progress display.
 * @param parts.open reports errors itself
 * @param parts.overtaken aborted when another model has been opened meanwhile
 */
export async function openLarge(
  chosen: File[],
  {
    actions,
    alerts,
    open,
    overtaken,
  }: {
    actions: Actions;
    alerts: Alerts;
    open: (files: NamedBytes[], cancelled: AbortSignal) => Promise<Opened | null>;
    overtaken: AbortSignal;
  },
) {
  const names = chosen.map(({ name }) => name).join(' and ');
  const all = chosen.reduce((sum, { size }) => sum + size, 0);
  const card = new Card(names);
  overtaken.addEventListener('abort', () => card.abort());
  /** Faces of the files that have been read so far. */
  let faces = 0;
  // The solver measures the limit, unless known already, while the file is read.
  const limit = actions.ask.mostFaces();
  limit.catch(() => {});
  actions.setStatus(`Reading ${names} …`);
  try {
    const files: NamedBytes[] = [];
    let read = 0;
    for (const file of chosen) {
      const count = faceCountOf(file);
      const withThis = () => faces + (count?.faces ?? 0);
      const reading = bytesOf(file, card.cancelled, (chunk) => {
        read += chunk.length;
        count?.take(chunk);
        card.show(`Reading ${names} · ${progress(read, all)}${facesIn(withThis())}`, read / all);
      });
      files.push({ name: file.name, bytes: await reading.catch(unreadable(file)) });
      faces = withThis();
    }
    const most = await card.unlessCancelled(limit);
    if (faces > most) {
      const size = groupDigits(faces);
      const question = `${names} has ${size} faces. Shape-Up stays interactive up to about ${groupDigits(most)} on this computer.`;
      actions.setStatus(`${names}: ${size} faces`);
      await card.ask(question, 'Load anyway');
    }
    card.show(`Opening ${names}${facesIn(faces)}`, null);
    const loaded = await open(files, card.cancelled);
    if (card.cancelled.aborted) throw new Cancelled();
    return loaded;
  } catch (error) {
    // What is said now is about the other model.
    if (overtaken.aborted) return;
    const isCancelled = card.cancelled.aborted || error instanceof Cancelled;
    if (!isCancelled) return void alerts.error(messageOf(error));
    alerts.clear();
    actions.setStatus('Cancelled');
  } finally {
    card.remove();
  }
}

/** @param onChunk called for each chunk */
async function bytesOf(file: File, cancelled: AbortSignal, onChunk: (chunk: Uint8Array) => void) {
  const bytes = new Uint8Array(file.size);
  // It may have grown since it was chosen.
  const reader = file.slice(0, file.size).stream().getReader();
  cancelled.addEventListener('abort', () => reader.cancel());
  for (let at = 0; ;) {
    const { done, value } = await reader.read();
    if (cancelled.aborted) throw new Cancelled();
    if (done) return bytes;
    bytes.set(value, at);
    at += value.length;
    onChunk(value);
  }
}

const facesIn = (faces: number) => (faces > 0 ? ` · ${groupDigits(faces)} faces` : '');

const progress = (read: number, all: number) => `${megabytes(read)} of ${megabytes(all)} MB`;

const SMALL = { class: 'small bordered' };

/** The progress card over the view. */
class Card {
  #abort = new AbortController();
  #text = element('p', { id: 'import-text' });
  #bar = element('progress', { 'aria-label': 'Reading progress', max: 1 });
  #buttons = element('div.row-buttons');
  #element;

  constructor(names: string) {
    const attributes = { class: 'message notice', role: 'group', 'aria-label': `Opening ${names}` };
    const words = element('div.import', this.#text, this.#bar);
    this.#element = element('div', attributes, words, this.#buttons);
    this.#buttons.append(button('Cancel', () => this.abort(), SMALL));
    this.#element.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      this.abort();
    });
    byId('messages').append(this.#element);
  }

  get cancelled() {
    return this.#abort.signal;
  }

  abort() {
    this.#abort.abort(new Cancelled());
  }

  /** @param part fraction from 0 to 1; null if unknown */
  show(text: string, part: number | null) {
    setText(this.#text, text);
    if (part === null) this.#bar.removeAttribute('value');
    else this.#bar.value = part;
  }

  /**
   * Asks a question and waits for the answer yes.
   * @returns rejects when cancelled
   */
  async ask(question: string, yes: string): Promise<void> {
    setText(this.#text, question);
    this.#bar.hidden = true;
    const answer = new Promise((done) => {
      // Screen readers read the question with the focused button.
      const described = { ...SMALL, 'aria-describedby': this.#text.id };
      const go = button(yes, () => done(undefined), described);
      this.#buttons.prepend(go);
      go.focus();
    });
    await this.unlessCancelled(answer);
    this.#buttons.firstElementChild?.remove();
    this.#bar.hidden = false;
  }

  /** Waits for a promise; rejects if the import is cancelled first. */
  unlessCancelled<T>(promise: Promise<T>): Promise<T> {
    const stopped = new Promise<never>((_, stop) => {
      if (this.cancelled.aborted) stop(new Cancelled());
      this.cancelled.addEventListener('abort', () => stop(new Cancelled()));
    });
    return Promise.race([promise, stopped]);
  }

  remove() {
    removeKeepingFocus(this.#element, () => this.#element.remove());
  }
}
