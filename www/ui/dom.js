/** Small helpers to build the page's elements. */

/** @typedef {HTMLElementTagNameMap} Tags */
/** @typedef {Record<string, string | number | boolean | ((event: any) => void)>} Attributes */
/** What is false or empty is left out. @typedef {Node | string | false | null | undefined} Child */

/**
 * Makes an element: `element('p.quiet', { id: 'note' }, 'Saved')`. Attributes that start with "on" are
 * listeners, boolean values set or leave out the attribute. `style` is set as declarations, because the
 * policy of the page refuses the attribute.
 * @template {keyof Tags | `${keyof Tags}.${string}`} Name
 * @param {Name} name its tag, and its classes, each after a dot
 * @param {...(Attributes | Child | Child[])} parts its attributes, where it has some, and its children
 * @returns {Name extends keyof Tags ? Tags[Name] : Name extends `${infer Tag extends keyof Tags}.${string}` ? Tags[Tag] : never}
 */
export function element(name, ...parts) {
  const [tag, ...classes] = name.split('.');
  const made = document.createElement(tag);
  if (classes.length > 0) made.className = classes.join(' ');
  // A form is sent by those that say so.
  if (made instanceof HTMLButtonElement) made.type = 'button';
  const [first] = parts;
  const isPlain = first && Object.getPrototypeOf(first) === Object.prototype;
  for (const [key, value] of Object.entries(isPlain ? first : {})) {
    if (typeof value === 'function') made.addEventListener(key.slice(2), value);
    else if (typeof value === 'boolean') made.toggleAttribute(key, value);
    else if (key === 'style') made.style.cssText = String(value);
    else made.setAttribute(key, String(value));
  }
  const children = /** @type {(Node | string)[]} */ (parts.slice(isPlain ? 1 : 0).flat());
  made.append(...children.filter(Boolean));
  return /** @type {any} */ (made);
}

/**
 * An icon of the sprite in index.html; decoration only, the control has the name.
 * @param {string} name
 */
export function icon(name) {
  const space = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(space, 'svg');
  svg.setAttribute('class', 'icon');
  svg.setAttribute('aria-hidden', 'true');
  const use = document.createElementNS(space, 'use');
  use.setAttribute('href', `#icon-${name}`);
  svg.append(use);
  return svg;
}

/**
 * The element with that id, which index.html is bound to have.
 * @template {HTMLElement} [Kind=HTMLElement]
 * @param {string} id
 * @returns {Kind}
 */
export function byId(id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`index.html has no #${id}`);
  return /** @type {Kind} */ (found);
}

/**
 * Takes an element's content away, or the element. Focus that was in it goes to the view, not nowhere.
 * @param {HTMLElement} place
 * @param {() => void} take
 */
export function leave(place, take) {
  const hadFocus = place.contains(document.activeElement);
  take();
  if (hadFocus) byId('viewport').focus({ preventScroll: true });
}

/**
 * Sets the text only when it differs: no needless layout several times a second.
 * @param {Node} node
 * @param {string} text
 */
export function setText(node, text) {
  const { firstChild } = node;
  // Another text node would have its style computed anew.
  const place = firstChild instanceof Text && !firstChild.nextSibling ? firstChild : node;
  if (place.textContent !== text) place.textContent = text;
}

/**
 * Sets the attribute only when it differs: what is set to what it was invalidates styles too.
 * @param {Element} place
 * @param {string} name
 * @param {string} value
 */
export function setAttribute(place, name, value) {
  if (place.getAttribute(name) !== value) place.setAttribute(name, value);
}

/**
 * The colour that a custom property stands for in the theme that is shown, where CSS does not resolve it.
 * @param {HTMLElement} place
 * @param {string} name
 */
export function colourOf(place, name) {
  const { style } = place;
  const before = style.color;
  style.color = `var(${name})`;
  const { color } = getComputedStyle(place);
  style.color = before;
  return color;
}

/** What is read while it changes, in a run or a drag, is renewed this often, in milliseconds. */
export const RENEW_MS = 125;

/**
 * Calls `action` at most once per `interval` milliseconds, and once more for the last call. Intervals
 * begin at the same times everywhere: what changes together is laid out once.
 * @template {unknown[]} Arguments
 * @param {number} interval
 * @param {(...values: Arguments) => void} action
 * @returns {(...values: Arguments) => void}
 */
export function throttled(interval, action) {
  /** The interval of the last call, counted from the start of the page. */
  let turn = -1;
  let timer = 0;
  /** @type {Arguments} */
  let latest;
  return (...values) => {
    latest = values;
    if (timer) return;
    const now = performance.now();
    const begins = (turn + 1) * interval;
    const call = () => {
      timer = 0;
      turn = Math.max(turn + 1, Math.floor(performance.now() / interval));
      action(...latest);
    };
    if (now >= begins) call();
    else timer = window.setTimeout(call, begins - now);
  };
}
