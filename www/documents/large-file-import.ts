/**
 * Opening of large files: a progress display, a cancel button, and a question before a mesh that is
 * too large for interactive work is loaded.
 */

import { ProgressCard } from '../ui/controls/progress-card.ts';
import { byId } from '../ui/dom.ts';
import { groupDigits, megabytes } from '../ui/words.ts';
import { Cancelled, messageOf, unreadable } from '../solver/errors.ts';
import { mainOf } from '../solver/opened-files.ts';
import type { NamedBytes, Opened } from '../solver/types.ts';
import type { Large } from './files.ts';
import type { Actions } from '../store/actions.ts';
import type { Alerts } from '../ui/controls/alerts.tsx';

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
    open: (files: NamedBytes[], large: Large) => Promise<Opened | null>;
    overtaken: AbortSignal;
  },
) {
  const names = chosen.map(({ name }) => name).join(' and ');
  const all = chosen.reduce((sum, { size }) => sum + size, 0);
  const stop = new AbortController();
  const cancel = () => stop.abort(new Cancelled());
  const cancelled = stop.signal;
  const place = byId('messages');
  const card = new ProgressCard(`Opening ${names}`, place, { class: 'message notice' }, cancel);
  const atWork = (now: boolean) => void place.classList.toggle('opening', now);
  overtaken.addEventListener('abort', cancel);
  // The solver measures the limit, unless known already, while the file is read.
  const most = unlessCancelled(actions.ask.mostFaces(), cancelled);
  most.catch(() => {});
  async function ask(faces: number) {
    const size = groupDigits(faces);
    const { name } = mainOf(chosen);
    const question = `${name} has ${size} faces. Shape-Up stays interactive up to about ${groupDigits(await most)} on this computer.`;
    actions.setStatus(`${name}: ${size} faces`);
    await unlessCancelled(card.ask(question, 'Load anyway'), cancelled);
    card.show(`Opening ${names} · ${size} faces`, null);
  }
  actions.setStatus(`Reading ${names} …`);
  try {
    const files: NamedBytes[] = [];
    let read = 0;
    for (const file of chosen) {
      const reading = bytesOf(file, cancelled, (chunk) => {
        read += chunk.length;
        card.show(`Reading ${names} · ${progress(read, all)}`, read / all);
      });
      files.push({ name: file.name, bytes: await reading.catch(unreadable(file)) });
    }
    card.show(`Opening ${names}`, null);
    const loaded = await open(files, { most, ask, atWork, cancelled });
    if (cancelled.aborted) throw new Cancelled();
    return loaded;
  } catch (error) {
    // What is said now is about the other model.
    if (overtaken.aborted) return;
    const isCancelled = cancelled.aborted || error instanceof Cancelled;
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

const progress = (read: number, all: number) => `${megabytes(read)} of ${megabytes(all)} MB`;

/** Rejects when `cancelled` is aborted, if that comes first. */
function unlessCancelled<T>(promise: Promise<T>, cancelled: AbortSignal): Promise<T> {
  const stopped = new Promise<never>((_, stop) => {
    if (cancelled.aborted) stop(new Cancelled());
    cancelled.addEventListener('abort', () => stop(new Cancelled()));
  });
  return Promise.race([promise, stopped]);
}
