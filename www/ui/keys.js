/** Keys: how a press is written in the table of commands, and how a key is called. */

/** The keys that press a button or open a list themselves. */
const ACTIVATING = new Set([' ', 'Enter']);
const NOT_TYPED_INTO = '[type="checkbox"], [type="radio"], [type="file"], [type="range"]';

/**
 * The keys of an event as the table writes them. Letters by what they print, not by where they
 * are: keyboards differ.
 * @param {KeyboardEvent} event
 */
export function chordOf(event) {
  const letter = event.key.length === 1;
  const key = letter ? event.key.toUpperCase() : event.key;
  const isLetter = letter && key !== event.key.toLowerCase();
  const shift = event.shiftKey && (isLetter || !letter);
  return `${event.ctrlKey || event.metaKey ? 'Ctrl+' : ''}${shift ? 'Shift+' : ''}${key}`;
}

/**
 * A digit by where its key is: some keyboards have other signs there. With its name before it on the
 * number pad, where other keys are the same ones without the lock. Empty for other keys.
 * @param {KeyboardEvent} event
 */
export function digitOf({ code, key, shiftKey, ctrlKey, metaKey }) {
  const [, pad, digit] = /^(Digit|Numpad)(\d)$/.exec(code) ?? [];
  if (!digit || ctrlKey || metaKey) return '';
  if (pad === 'Numpad') return key === digit ? code : '';
  return `${shiftKey ? 'Shift+' : ''}${digit}`;
}

/** Whether a key writes into a field, or presses what has the focus. @param {KeyboardEvent} event */
export function isTyping({ target, key }) {
  if (!(target instanceof HTMLElement)) return false;
  if (target.matches('select, textarea') || target.matches(`input:not(${NOT_TYPED_INTO})`))
    return true;
  return ACTIVATING.has(key) && target.matches('button, summary, a, input:not([type="range"])');
}

const IS_MAC = /Mac|iPhone|iPad/.test(globalThis.navigator?.platform ?? '');

/**
 * A key as people read it.
 * @param {string} chord
 */
export function keyName(chord) {
  return chord
    .replace('Ctrl+', IS_MAC ? '⌘' : 'Ctrl+')
    .replace('Shift+', IS_MAC ? '⇧' : 'Shift+')
    .replace('Numpad', 'Num ')
    .replace(/ $/, 'Space')
    .replace('Escape', 'Esc');
}
