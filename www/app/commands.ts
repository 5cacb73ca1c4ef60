/** Binds buttons (`data-command`) and keys to the commands of `command-table.ts`. */

import { effect } from '@preact/signals';
import { isEnabled, perform } from '../store/perform.ts';
import { setText } from '../ui/dom.ts';
import {
  chordOf,
  digitOf,
  isSwitchedOff,
  isTypedInto,
  isTyping,
  keyInTitle,
  ofText,
} from '../ui/keys.ts';
import type { Command } from './context.ts';
import type { Store } from '../store/state.ts';

export function bindButtons(commands: Command[], store: Store) {
  const byName = new Map(commands.map((command) => [command.id, command]));
  for (const button of document.querySelectorAll('button[data-command]')) {
    if (!(button instanceof HTMLButtonElement)) continue;
    const command = byName.get(button.dataset.command ?? '');
    if (!command) throw new Error(`no command is called ${button.dataset.command}`);
    button.addEventListener('click', () => perform(command, store));
    const { state } = store;
    effect(() => {
      const words = command.title ? command.title(state) : command.label;
      // Its key may be switched off.
      const title = words + keyInTitle(...command.keys);
      // Assign changes only: assigning the same value also invalidates styles and notifies
      // mutation observers.
      if (button.title !== title) button.title = title;
      const disabled = !isEnabled(command, state);
      if (button.disabled !== disabled) button.disabled = disabled;
      const pressed = command.pressed ? String(command.pressed(state)) : null;
      if (pressed !== button.getAttribute('aria-pressed') && pressed !== null) {
        button.setAttribute('aria-pressed', pressed);
      }
    });
  }
}

/** @param settled see {@link perform} */
export function bindKeys(commands: Command[], store: Store, settled: () => Promise<void>) {
  window.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || event.altKey) return;
    const chord = chordOf(event);
    if (!chord.startsWith('Ctrl+') && chord !== 'Escape' && isTyping(event)) return;
    // All of the text, not of the mesh.
    if (chord === 'Ctrl+A' && isTypedInto(document.activeElement)) return;
    const digit = digitOf(event);
    // With Shift, the printed character has precedence: some keyboards have + on a digit key.
    const names = digit.startsWith('Shift') ? [chord, digit] : [digit, chord];
    const [command] = names.flatMap((name) => commands.filter(({ keys }) => keys.includes(name)));
    if (!command || isSwitchedOff(chord)) return;
    // Modal dialogs and open popovers handle their own keys, and Escape closes them.
    const isOver = document.querySelector('dialog:modal, :popover-open') !== null;
    const isOfText = ofText(chord) && isTypedInto(document.activeElement);
    // The browser's own shortcut (open, save, print) never applies, even if the command is
    // disabled.
    if (isOver ? isShortcut(chord) && !isOfText : chord !== 'Escape') event.preventDefault();
    if (isOver || (event.repeat && !command.repeats)) return;
    if (chord.startsWith('Ctrl+')) commitTyping();
    perform(command, store, settled);
  });
}

/** Whether a browser may have a shortcut of its own for a chord. */
const isShortcut = (chord: string) => /^(Ctrl\+|F\d)/.test(chord);

/** Binds the label and icon of the button that is both Run and Pause. */
export function bindRunButton(button: HTMLButtonElement, store: Store) {
  const label = button.querySelector('span');
  const use = button.querySelector('use');
  store.subscribe(['running', 'refining'], ({ running, refining }) => {
    const pauses = running || refining;
    if (label) setText(label, pauses ? 'Pause' : 'Run');
    use?.setAttribute('href', pauses ? '#icon-pause' : '#icon-run');
  });
}

/**
 * Commits what is being typed, as leaving its field does: browsers tell of a change only then, and a
 * key that saves or undoes acts on what the user sees. The field keeps the focus.
 */
function commitTyping() {
  const field = document.activeElement;
  if (!(field instanceof HTMLInputElement || field instanceof HTMLTextAreaElement)) return;
  field.blur();
  if (field.isConnected) field.focus({ preventScroll: true });
}
