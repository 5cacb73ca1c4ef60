/** Copying of text to the clipboard. */

const NOT_COPIED = 'The browser did not allow copying. Select the text and copy it.';

/**
 * Copies a text and returns the message to show.
 * @param refused the message if copying is not allowed
 */
export const copyText = (text: string, refused: string = NOT_COPIED) =>
  navigator.clipboard.writeText(text).then(
    () => 'Copied to the clipboard.',
    () => refused,
  );
