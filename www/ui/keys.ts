/** Keys: the chords of the table of commands, and their display names. */

import { signal } from '@preact/signals';
import { getItem, setItem } from './safe-storage.ts';

/** Keys that activate a focused button or list. */
const ACTIVATING = new Set([' ', 'Enter']);
/** Keys that move a slider to an end, or by a large step. */
const SLIDING = new Set(['Home', 'End', 'PageUp', 'PageDown']);
const NOT_TYPED_INTO = '[type="checkbox"], [type="radio"], [type="file"], [type="range"]';

/**
 * Returns the chord of an event as in the table of commands. Letters are identified by character,
 * not by position, as keyboard layouts differ.
 */
export function chordOf(event: KeyboardEvent) {
  const letter = event.key.length === 1;
  const key = letter ? event.key.toUpperCase() : event.key;
  const isLetter = letter && key !== event.key.toLowerCase();
  const shift = event.shiftKey && (isLetter || !letter);
  return `${event.ctrlKey || event.metaKey ? 'Ctrl+' : ''}${shift ? 'Shift+' : ''}${key}`;
}

/**
 * Returns a digit by the position of its key, as some layouts have other characters there; empty
 * for other keys. Digits of the number pad, with Num Lock only, are prefixed by `Numpad`.
 */
export function digitOf({ code, key, shiftKey, ctrlKey, metaKey }: KeyboardEvent) {
  const [, pad, digit] = /^(Digit|Numpad)(\d)$/.exec(code) ?? [];
  if (!digit || ctrlKey || metaKey) return '';
  if (pad === 'Numpad') return key === digit ? code : '';
  return `${shiftKey ? 'Shift+' : ''}${digit}`;
}

/** Whether a key types into a field, moves a slider, or activates the focused control. */
export function isTyping({ target, key }: KeyboardEvent) {
  if (!(target instanceof HTMLElement)) return false;
  if (target.matches('select') || isTypedInto(target)) return true;
  if (SLIDING.has(key) && target.matches('input[type="range"]')) return true;
  return ACTIVATING.has(key) && target.matches('button, summary, a, input:not([type="range"])');
}

/** Whether text or a number is typed into an element. */
export const isTypedInto = (target: Element | null) =>
  target?.matches(`textarea, input:not(${NOT_TYPED_INTO})`) ?? false;

/** Whether a chord of the table of commands also changes the text of a field. */
export const ofText = (chord: string) => ['Ctrl+Z', 'Ctrl+Shift+Z', 'Ctrl+Y'].includes(chord);

/** The direction of each arrow key on the screen, in which y points down. */
export const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

export const IS_MAC = /Mac|iPhone|iPad/.test(globalThis.navigator?.platform ?? '');

/** The key of commands, as it is called on this system. */
export const CTRL = IS_MAC ? '⌘' : 'Ctrl';

/** Returns the display name of a chord. */
export function keyName(chord: string) {
  return chord
    .replace('Ctrl+', IS_MAC ? '⌘' : 'Ctrl+')
    .replace('Shift+', IS_MAC ? '⇧' : 'Shift+')
    .replace('Numpad', 'Num ')
    .replace(/ $/, 'Space')
    .replace('Escape', 'Esc');
}

/** Storage key of the switch. */
const KEY = 'shape-up.single-keys';

/** Whether a chord of the table of commands is switched off. */
export const isSwitchedOff = (chord: string) =>
  !singleKeys.on && /^(Shift\+|Numpad)?[^ ]$/u.test(chord);

/** Returns the display names of those of these chords that work. */
export const workingKeys = (...chords: string[]) =>
  chords.filter((chord) => !isSwitchedOff(chord)).map(keyName);

/** Returns the first of them; empty if none works. */
export const workingKey = (...chords: string[]) => workingKeys(...chords)[0] ?? '';

/** Returns that name as the end of a title, in brackets. */
export function keyInTitle(...chords: string[]) {
  const key = workingKey(...chords);
  return key && ` (${key})`;
}

const isOn = signal(getItem(KEY) !== 'off');

/**
 * Switch for shortcuts of single printable keys, required by WCAG 2.1.4: users of speech input, or
 * with a tremor, trigger them by accident. The switch is in the help. What names a key follows it.
 */
export const singleKeys = {
  get on() {
    return isOn.value;
  },
  set(on: boolean) {
    isOn.value = on;
    setItem(KEY, on ? 'on' : 'off');
  },
};
