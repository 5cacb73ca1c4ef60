/** Helpers to build and update elements. */

const NAMESPACE = 'http://www.w3.org/2000/svg';

type Tags = HTMLElementTagNameMap;
export type Attributes = Record<string, string | number | boolean | ((event: never) => void)>;
/** Falsy children are skipped. */
type Child = Node | string | false | null | undefined;

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

/**
 * Makes an element: `element('p.quiet', { id: 'note' }, 'Saved')`. Attributes whose names start
 * with "on" are listeners; boolean values set or omit the attribute. `style` is set through the
 * DOM, because the content security policy forbids the attribute.
 * @param name its tag, and its classes, each after a dot
 * @param parts its attributes, if any, and its children
 */
export function element<Name extends keyof Tags | `${keyof Tags}.${string}`>(
  name: Name,
  ...parts: (Attributes | Child | Child[])[]
): Name extends keyof Tags
  ? Tags[Name]
  : Name extends `${infer Tag extends keyof Tags}.${string}`
    ? Tags[Tag]
    : never {
  const [tag, ...classes] = name.split('.');
  const made = document.createElement(tag);
  if (classes.length > 0) made.className = classes.join(' ');
  // Buttons submit forms only if their type is set explicitly.
  if (made instanceof HTMLButtonElement) made.type = 'button';
  const [first] = parts;
  const isPlain = first && Object.getPrototypeOf(first) === Object.prototype;
  for (const [key, value] of Object.entries(isPlain ? first : {})) {
    if (typeof value === 'function') made.addEventListener(key.slice(2), value as EventListener);
    else if (typeof value === 'boolean') made.toggleAttribute(key, value);
    else if (key === 'style') made.style.cssText = String(value);
    else made.setAttribute(key, String(value));
  }
  const children = parts.slice(isPlain ? 1 : 0).flat() as (Node | string)[];
  made.append(...children.filter(Boolean));
  return made as never;
}

/** Makes an icon from the sprite in index.html; hidden from screen readers. */
export function icon(name: string) {
  const use = svgElement('use', { href: `#icon-${name}` });
  return svgElement('svg', { class: 'icon', 'aria-hidden': 'true' }, use);
}

/** Returns the element with an id, which index.html must contain. */
export function byId<Kind extends Element = HTMLElement>(id: string): Kind {
  const found = document.getElementById(id);
  if (!found) throw new Error(`index.html has no #${id}`);
  return found as Element as Kind;
}

/** Sets the text if it differs, to avoid needless layout several times a second. */
export function setText(node: Node, text: string) {
  const { firstChild } = node;
  // Reuse the text node: a new one would need style computation.
  const place = firstChild instanceof Text && !firstChild.nextSibling ? firstChild : node;
  if (place.textContent !== text) place.textContent = text;
}

/** Resolves a custom property to a colour in the current theme, for use outside CSS. */
export function colourOf(place: HTMLElement, name: string) {
  const { style } = place;
  const before = style.color;
  style.color = `var(${name})`;
  const { color } = getComputedStyle(place);
  style.color = before;
  return color;
}

/** The update interval of values that change during a run or a drag, in milliseconds. */
export const RENEW_MS = 125;

/**
 * Calls `action` at most once per `interval` milliseconds, and once more for the last call.
 * Intervals are aligned to a common clock, so that changes of several callers share one layout.
 */
export function throttled<Arguments extends unknown[]>(
  interval: number,
  action: (...values: Arguments) => void,
): (...values: Arguments) => void {
  /** The index of the interval of the last call, from the start of the page. */
  let lastInterval = -1;
  let timer = 0;
  let latest: Arguments;
  return (...values) => {
    latest = values;
    if (timer) return;
    const now = performance.now();
    const begins = (lastInterval + 1) * interval;
    const call = () => {
      timer = 0;
      lastInterval = Math.max(lastInterval + 1, Math.floor(performance.now() / interval));
      action(...latest);
    };
    if (now >= begins) call();
    else timer = window.setTimeout(call, begins - now);
  };
}
