/** Buttons, and the icons and keys on them. */

import { workingKey } from '../keys.ts';
import type { ComponentProps } from 'preact';

type ButtonProps = ComponentProps<'button'>;

/** An icon from the sprite in index.html; hidden from screen readers. */
export const Icon = ({ name }: { name: string }) => (
  <svg class="icon" aria-hidden="true">
    <use href={`#icon-${name}`} />
  </svg>
);

/** The first of these chords that works, beside the name of its command. */
export function Key({ of }: { of: readonly string[] }) {
  const key = workingKey(...of);
  return key ? <kbd>{key}</kbd> : null;
}

export const Button = ({ class: own = 'bordered', ...rest }: ButtonProps) => (
  <button type="button" class={own} {...rest} />
);

/** A button with a cross that closes or removes something. */
export const CloseButton = ({ label, ...rest }: ButtonProps & { label: string }) => (
  <button type="button" class="tiny" aria-label={label} {...rest}>
    <Icon name="close" />
  </button>
);
