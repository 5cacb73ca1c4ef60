/** Elements of SVG drawings. */

const NAMESPACE = 'http://www.w3.org/2000/svg';

/** Makes an SVG element: `svgElement('circle', { class: 'dot', r: 3 })`. */
export function svgElement<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Record<string, string | number> = {},
  ...children: Node[]
): SVGElementTagNameMap[Tag] {
  const made = document.createElementNS(NAMESPACE, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  made.append(...children);
  return made;
}
