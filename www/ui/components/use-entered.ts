/** What was entered in a field, until its edit has settled. */

import { useSignal } from '@preact/signals';
import { useContext } from 'preact/hooks';
import { Subject } from './use-typed.ts';

/**
 * Keeps what was entered, so that the field shows it and the next step starts from it while the
 * solver is still at work. It is forgotten with another `Subject`; a field that shows one of several values
 * has a `key` for each.
 */
export function useEntered<Value>() {
  const subject = useContext(Subject);
  const entered = useSignal<{ value: Value; subject: unknown } | null>(null);
  return {
    /** Returns what was entered last; `value` once it has settled. */
    over(value: Value): Value {
      const own = entered.value;
      return own && own.subject === subject ? own.value : value;
    },
    /** @param edit settles when the page shows what has become of the value; anything but a promise has */
    enter(value: Value, edit: unknown) {
      const own = { value, subject };
      entered.value = own;
      const settle = () => {
        if (entered.peek() === own) entered.value = null;
      };
      Promise.resolve(edit).then(settle, settle);
    },
  };
}
