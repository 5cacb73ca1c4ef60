/** What leaves the page: texts to the clipboard, files to the downloads. */

import { element } from './dom.ts';

const NOT_COPIED = 'The browser did not allow copying. Select the text and copy it.';

/**
 * Copies a text and returns the message to show.
 * @param refused the message if copying is not allowed
 */
export async function copyText(text: string, refused: string = NOT_COPIED): Promise<string> {
  try {
    // There is none at an address without encryption: that throws, too.
    await navigator.clipboard.writeText(text);
    return 'Copied to the clipboard.';
  } catch {
    return refused;
  }
}

/** How long the browser may take to fetch the content, in milliseconds. */
const FETCHED_AFTER_MS = 60_000;

/**
 * Saves a file through the browser's download.
 * @param name of the file
 */
export function saveFile(name: string, content: BlobPart, type: string) {
  const address = URL.createObjectURL(new Blob([content], { type }));
  element('a', { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), FETCHED_AFTER_MS);
}
