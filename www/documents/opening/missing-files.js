/** A scene whose mesh, other surface or other pose is in a file that was not given: asks for it. */

import { element } from '../../ui/dom.js';

/** @typedef {import("../../solver/messages.js").NamedBytes} NamedBytes */

/**
 * What can be done about files that could not be opened: choosing those that a scene names and that are not
 * among them. Nothing where none is missing.
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
    // Whatever the file is called here, it is meant to be the one that is missing.
    const found = chosen.map((file, i) =>
      missing.length === 1 ? [missing[i], file] : [file.name, file],
    );
    if (found.length > 0)
      files.open([...given, ...(await Promise.all(found.map(read)))], origin).catch(() => {});
  };
  return [{ label: `Choose ${missing.join(' and ')} …`, action }];
}

/** @param {(string | File)[]} named @returns {Promise<NamedBytes>} */
async function read([path, file]) {
  const name = String(path).split('/').pop() ?? '';
  return { name, bytes: new Uint8Array(await /** @type {File} */ (file).arrayBuffer()) };
}

/** @param {boolean} multiple @returns {Promise<File[]>} empty where nothing is chosen */
const choose = (multiple) =>
  new Promise((done) => {
    const input = element('input', { type: 'file', accept: '.obj,.off,.mesh', multiple });
    input.onchange = () => done([...(input.files ?? [])]);
    input.oncancel = () => done([]);
    input.click();
  });
