/** Saving of files through the browser's download. */

import { element } from './dom.js';

/** How long the browser may take to fetch the content, in milliseconds. */
const FETCHED_AFTER_MS = 60_000;

/**
 * @param {string} name of the file
 * @param {BlobPart} content
 * @param {string} type
 */
export function saveFile(name, content, type) {
  const address = URL.createObjectURL(new Blob([content], { type }));
  element('a', { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), FETCHED_AFTER_MS);
}
