/** Files from the user that are chosen because a scene names them. */

import { unreadable } from '../solver/errors.ts';
import { element } from '../ui/dom.ts';
import type { NamedBytes } from '../solver/types.ts';
import type { Actions } from '../store/actions.ts';
import type { Offer } from '../ui/controls/alerts.tsx';
import type { Files, Origin } from './files.ts';

/**
 * Returns an offer to choose the files that a scene names and that are missing; empty if none is.
 */
export async function offersToChoose(
  given: NamedBytes[],
  actions: Actions,
  files: Files,
  origin: Origin,
): Promise<Offer[]> {
  const missing = await actions.ask.missingFiles(given).catch(() => []);
  if (missing.length === 0) return [];
  const label = `Choose ${missing.join(' and ')} …`;
  const action = async () => {
    const chosen = await choose(missing);
    if (chosen.length === 0) return;
    const opened = files.openings.begin(async (opening) => {
      const read = readFor(missing, chosen);
      // Another choice may be right.
      const found = await actions.reportErrors(read, { label, action });
      if (found) await files.open([...given, ...found], origin, { opening });
    });
    // The alert gives the reason of a refusal.
    opened.catch(() => {});
  };
  return [{ label, action }];
}

/**
 * Reads the files that were chosen for missing ones. A single one is taken for the missing one, whatever
 * its name, but not its ending, by which it is read.
 */
async function readFor([first, ...others]: string[], chosen: File[]) {
  const name = others.length === 0 ? first.split('/').pop() : undefined;
  const ending = endingOf(first);
  const other = chosen.find((file) => name && endingOf(file.name) !== ending);
  if (other) {
    const needed = ending ? `a ${ending} file` : `${name}, a file without an ending`;
    throw new Error(`${other.name} is of another format: the scene needs ${needed}.`);
  }
  return Promise.all(chosen.map((file) => namedBytes(file, name)));
}

const endingOf = (name: string) => /\.[^./]*$/.exec(name)?.[0].toLowerCase() ?? '';

/** @returns empty if cancelled */
const choose = (missing: string[]): Promise<File[]> =>
  new Promise((done) => {
    const accept = [...new Set(missing.map(endingOf))].join();
    const input = element('input', { type: 'file', accept, multiple: missing.length > 1 });
    input.onchange = () => done([...(input.files ?? [])]);
    input.oncancel = () => done([]);
    input.click();
  });

/**
 * Reads a file; rejects if it cannot be read from the disk.
 * @param name in place of its own
 */
export async function namedBytes(file: File, name: string = file.name): Promise<NamedBytes> {
  return { name, bytes: new Uint8Array(await file.arrayBuffer().catch(unreadable(file))) };
}
