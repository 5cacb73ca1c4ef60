/** Helpers to build and update elements. */

import { svgElement } from './svg.js';

/** @typedef {HTMLElementTagNameMap} Tags */
/** @typedef {Record<string, string | number | boolean | ((event: any) => void)>} Attributes */
/** Falsy children are skipped. @typedef {Node | string | false | null | undefined} Child */

/**
 * Makes an element: `element('p.quiet', { id: 'note' }, 'Saved')`. Attributes whose names start
 * with "on" are listeners; boolean values set or omit the attribute. `style` is set through the
 * DOM, because the content security policy forbids the attribute.
 * @template {keyof Tags | `${keyof Tags}.${string}`} Name
 * @param {Name} name its tag, and its classes, each after a dot
 * @param {...(Attributes | Child | Child[])} parts its attributes, if any, and its children
 * @returns {Name extends keyof Tags ? Tags[Name] : Name extends `${infer Tag extends keyof Tags}.${string}` ? Tags[Tag] : never}
 */
export function element(name, ...parts) {
  const [tag, ...classes] = name.split('.');
  const made = document.createElement(tag);
  if (classes.length > 0) made.className = classes.join(' ');
  // Buttons submit forms only if their type is set explicitly.
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
 * Makes an icon from the sprite in index.html; hidden from screen readers.
 * @param {string} name
 */
export function icon(name) {
  const use = svgElement('use', { href: `#icon-${name}` });
  return svgElement('svg', { class: 'icon', 'aria-hidden': 'true' }, use);
}

/**
 * Returns the element with an id, which index.html must contain.
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
 * Runs `remove`, which removes or hides an element or its content; focus inside goes to the view.
 * @param {HTMLElement} place
 * @param {() => void} remove
 */
export function removeKeepingFocus(place, remove) {
  const hadFocus = place.contains(document.activeElement);
  remove();
  if (hadFocus) byId('viewport').focus({ preventScroll: true });
}

/**
 * Sets the text if it differs, to avoid needless layout several times a second.
 * @param {Node} node
 * @param {string} text
 */
export function setText(node, text) {
  const { firstChild } = node;
  // Reuse the text node: a new one would need style computation.
  const place = firstChild instanceof Text && !firstChild.nextSibling ? firstChild : node;
  if (place.textContent !== text) place.textContent = text;
}

/**
 * Sets the attribute if it differs: setting an equal value invalidates styles too.
 * @param {Element} place
 * @param {string} name
 * @param {string} value
 */
export function setAttribute(place, name, value) {
  if (place.getAttribute(name) !== value) place.setAttribute(name, value);
}

/**
 * Resolves a custom property to a colour in the current theme, for use outside CSS.
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

/** The update interval of values that change during a run or a drag, in milliseconds. */
export const RENEW_MS = 125;

/**
 * Calls `action` at most once per `interval` milliseconds, and once more for the last call.
 * Intervals are aligned to a common clock, so that changes of several callers share one layout.
 * @template {unknown[]} Arguments
 * @param {number} interval
 * @param {(...values: Arguments) => void} action
 * @returns {(...values: Arguments) => void}
 */
export function throttled(interval, action) {
  /** The index of the interval of the last call, from the start of the page. */
  let lastInterval = -1;
  let timer = 0;
  /** @type {Arguments} */
  let latest;
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
