/** Requests the files that a scene names but that were not given: mesh, surface or other pose. */

import { element } from '../../ui/dom.ts';
import { namedBytes } from './named-bytes.ts';
import type { NamedBytes } from '../../solver/types.ts';
import type { Actions } from '../../store/actions.ts';
import type { Files, Origin } from '../files.ts';
import type { Offer } from '../../ui/controls/alerts.ts';

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
  const action = async () => {
    const chosen = await choose(missing.length > 1);
    // A single chosen file is taken for the missing one, whatever its name.
    const name = missing.length === 1 ? missing[0].split('/').pop() : undefined;
    if (chosen.length === 0) return;
    const opened = files.openings.begin(async (opening) => {
      const read = Promise.all(chosen.map((file) => namedBytes(file, name)));
      const found = await actions.reportErrors(read);
      if (found) await files.open([...given, ...found], origin, { opening });
    });
    // The alert gives the reason of a refusal.
    opened.catch(() => {});
  };
  return [{ label: `Choose ${missing.join(' and ')} …`, action }];
}

/** @returns empty if cancelled */
const choose = (multiple: boolean): Promise<File[]> =>
  new Promise((done) => {
    const input = element('input', { type: 'file', accept: '.obj,.off,.mesh', multiple });
    input.onchange = () => done([...(input.files ?? [])]);
    input.oncancel = () => done([]);
    input.click();
  });
