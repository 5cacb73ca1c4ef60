/** Copying of text to the clipboard. */

const NOT_COPIED = 'This browser does not let the page copy: select it and copy it yourself.';

/**
 * Copies a text and returns the message to show.
 * @param {string} text
 * @param {string} [refused] the message if copying is not allowed
 */
export const copyText = (text, refused = NOT_COPIED) =>
  navigator.clipboard.writeText(text).then(
    () => 'Copied to the clipboard.',
    () => refused,
  );
