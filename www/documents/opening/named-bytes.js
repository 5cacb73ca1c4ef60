/** Reading of a chosen file. */

/**
 * @param {File} file
 * @param {string} [name] in place of its own
 * @returns {Promise<import("../../solver/messages.js").NamedBytes>}
 */
export async function namedBytes(file, name = file.name) {
  return { name, bytes: new Uint8Array(await file.arrayBuffer()) };
}
