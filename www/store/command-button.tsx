/** The button of a command. */

import { useComputed } from '@preact/signals';
import { Button } from '../ui/components/buttons.tsx';
import { keyInTitle } from '../ui/keys.ts';
import { isEnabled, perform } from './perform.ts';
import { useApp } from './use-app.ts';
import type { ComponentProps } from 'preact';
import type { State } from './state.ts';

/** Its title and key, and whether it is enabled and pressed, are those of the command `of`. */
export function CommandButton({
  of,
  onClick,
  ...rest
}: Omit<ComponentProps<'button'>, 'of' | 'role'> & { of: string; role?: 'switch' }) {
  const { store, commands } = useApp();
  const command = commands.find(({ id }) => id === of);
  if (!command) throw new Error(`no command is called ${of}`);
  // What it depends on is followed where the command reads it.
  const state = store.state as State;
  const title = useComputed(() => command.title?.(state) ?? command.label).value;
  const isDisabled = useComputed(() => !isEnabled(command, state)).value;
  const isPressed = useComputed(() => command.pressed?.(state)).value;
  return (
    <Button
      title={title + keyInTitle(...command.keys)}
      disabled={isDisabled}
      aria-pressed={isPressed}
      onClick={(event) => {
        perform(command, store);
        onClick?.(event);
      }}
      {...rest}
    />
  );
}
