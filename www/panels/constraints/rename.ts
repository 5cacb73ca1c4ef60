/** Renaming a constraint in its row. */

import '../../ui/styles/lists.css';
import { element } from '../../ui/dom.ts';

/**
 * Replaces the button that shows the name by a field. Enter or leaving the field accepts the name,
 * Escape restores the old one; an empty name means the label of the kind.
 * @param opener the button that shows the name
 * @param name of the row, empty when it has none
 * @param label of its kind
 */
export function editName(
  opener: HTMLElement,
  name: string,
  label: string,
  rename: (name: string) => void,
) {
  const field = element('input.rename', {
    type: 'text',
    'aria-label': 'Name of the constraint',
    placeholder: label,
    value: name,
    maxlength: '80',
    autocomplete: 'off',
  });
  let done = false;
  const finish = (keep: boolean) => {
    if (done) return;
    done = true;
    const focused = document.activeElement === field;
    const now = field.value.trim();
    field.replaceWith(opener);
    if (focused) opener.focus();
    if (keep && now !== name) rename(now === label ? '' : now);
  };
  field.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter' && event.key !== 'Escape') return;
    event.preventDefault();
    event.stopPropagation();
    finish(event.key === 'Enter');
  });
  field.addEventListener('blur', () => finish(true));
  opener.replaceWith(field);
  field.focus();
  field.select();
}
