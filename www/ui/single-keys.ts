/**
 * Switch for shortcuts of single printable keys, required by WCAG 2.1.4: users of speech input, or
 * with a tremor, trigger them by accident. The switch is in the help.
 */

import { getItem, setItem } from './safe-storage.ts';

const KEY = 'shape-up.single-keys';

/** Whether a chord of the table of commands is switched off. */
export const isSwitchedOff = (chord: string) => !singleKeys.on && /^(Shift\+)?[^ ]$/u.test(chord);

export const singleKeys = {
  on: getItem(KEY) !== 'off',
  set(on: boolean) {
    singleKeys.on = on;
    setItem(KEY, on ? 'on' : 'off');
  },
};
