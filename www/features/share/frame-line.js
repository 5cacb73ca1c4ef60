/** The line of HTML that embeds a model in another page. */

/** Escapes in a quoted HTML attribute. */
const ESCAPES = /** @type {Record<string, string>} */ ({
  '&': '&amp;',
  '"': '&quot;',
  '<': '&lt;',
});

/**
 * @param {string} link to the scene
 * @param {string} title of the model
 */
export function frameLine(link, title) {
  const address = new URL(link);
  address.pathname = address.pathname.replace(/[^/]*$/, 'embed.html');
  const [plain, hash] = address.href.split('#');
  const source = escaped(`${plain.split('?')[0]}?embed#${hash}`);
  return `<iframe src="${source}" title="${escaped(title)}, in Shape-Up" width="720" height="480" loading="lazy" style="border: 0"></iframe>`;
}

/** @param {string} text */
const escaped = (text) => text.replaceAll(/[&"<]/g, (character) => ESCAPES[character]);
