/** Saving of files through the browser's download. */

import { element } from './dom.ts';

/** How long the browser may take to fetch the content, in milliseconds. */
const FETCHED_AFTER_MS = 60_000;

/** @param name of the file */
export function saveFile(name: string, content: BlobPart, type: string) {
  const address = URL.createObjectURL(new Blob([content], { type }));
  element('a', { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), FETCHED_AFTER_MS);
}
