/** Text to the clipboard. */

const NOT_COPIED = 'This browser does not let the page copy: select it and copy it yourself.';

/**
 * What is said of it.
 * @param {string} text
 * @param {string} [refused] what is said where it cannot be copied
 */
export const copyText = (text, refused = NOT_COPIED) =>
  navigator.clipboard.writeText(text).then(
    () => 'Copied to the clipboard.',
    () => refused,
  );
