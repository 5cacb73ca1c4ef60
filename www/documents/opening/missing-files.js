/** Requests the files that a scene names but that were not given: mesh, surface or other pose. */

import { element } from '../../ui/dom.js';
import { namedBytes } from './named-bytes.js';

/** @typedef {import("../../solver/messages.js").NamedBytes} NamedBytes */

/**
 * Returns an offer to choose the files that a scene names and that are missing; empty if none is.
 * @param {NamedBytes[]} given
 * @param {import("../../store/actions.js").Actions} actions
 * @param {import("../files.js").Files} files
 * @param {import("../files.js").Origin} origin
 * @returns {Promise<import("../../ui/controls/alerts.js").Offer[]>}
 */
export async function offersToChoose(given, actions, files, origin) {
  const missing = await actions.missingFiles(given).catch(() => []);
  if (missing.length === 0) return [];
  const action = async () => {
    const chosen = await choose(missing.length > 1);
    // A single chosen file is taken for the missing one, whatever its name.
    const name = missing.length === 1 ? missing[0].split('/').pop() : undefined;
    const found = await actions.reportErrors(
      Promise.all(chosen.map((file) => namedBytes(file, name))),
    );
    if (found?.length) files.open([...given, ...found], origin).catch(() => {});
  };
  return [{ label: `Choose ${missing.join(' and ')} …`, action }];
}

/** @param {boolean} multiple @returns {Promise<File[]>} empty if cancelled */
const choose = (multiple) =>
  new Promise((done) => {
    const input = element('input', { type: 'file', accept: '.obj,.off,.mesh', multiple });
    input.onchange = () => done([...(input.files ?? [])]);
    input.oncancel = () => done([]);
    input.click();
  });
