/** The line of HTML that embeds a model in another page. */

/** Escapes in a quoted HTML attribute. */
const ESCAPES = {
  '&': '&amp;',
  '"': '&quot;',
  '<': '&lt;',
} as Record<string, string>;

/**
 * @param link to the scene
 * @param title of the model
 */
export function frameLine(link: string, title: string) {
  const address = new URL(link);
  address.pathname = address.pathname.replace(/[^/]*$/, 'embed.html');
  const [plain, hash] = address.href.split('#');
  const source = escaped(`${plain.split('?')[0]}?embed#${hash}`);
  return `<iframe src="${source}" title="${escaped(title)}, in Shape-Up" width="720" height="480" loading="lazy" style="border: 0"></iframe>`;
}

const escaped = (text: string) => text.replaceAll(/[&"<]/g, (character) => ESCAPES[character]);
