/**
 * Keys without Ctrl that print something can be switched off, as WCAG 2.1.4 asks: whoever speaks to
 * a computer, or has unsteady hands, presses them without meaning to. The switch is in the help.
 */

import { recall, remember } from './safe-storage.js';

const KEY = 'shape-up.single-keys';

/** Whether a key as the table of commands writes it has no meaning now. @param {string} chord */
export const isSwitchedOff = (chord) => !singleKeys.on && /^(Shift\+)?[^ ]$/u.test(chord);

export const singleKeys = {
  on: recall(KEY) !== 'off',
  /** @param {boolean} on */
  set(on) {
    singleKeys.on = on;
    remember(KEY, on ? 'on' : 'off');
  },
};
