/**
 * Keys without Ctrl that print something can be switched off, as WCAG 2.1.4 asks: whoever speaks to
 * a computer, or has unsteady hands, presses them without meaning to.
 */

import { element } from './dom.js';

const KEY = 'shape-up.single-keys';
let on = recall();

/** Whether a key as the table of commands writes it has no meaning now. @param {string} chord */
export function isSwitchedOff(chord) {
  return !on && /^(Shift\+)?[^ ]$/u.test(chord);
}

/** The switch. */
export function singleKeysSwitch() {
  const box = element('input', {
    type: 'checkbox',
    checked: on,
    onchange: () => {
      on = box.checked;
      try {
        localStorage.setItem(KEY, on ? 'on' : 'off');
      } catch {
        // Storage is blocked: it holds for this visit.
      }
    },
  });
  return element(
    'label',
    { class: 'single-keys' },
    box,
    element('span', {}, 'Letters, digits and signs act without Ctrl'),
  );
}

function recall() {
  try {
    return localStorage.getItem(KEY) !== 'off';
  } catch {
    return true;
  }
}
