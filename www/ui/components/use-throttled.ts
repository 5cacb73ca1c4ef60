/** Values that change with every frame, shown a few times a second. */

import { untracked, useSignal, useSignalEffect } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { RENEW_MS, throttled } from '../dom.ts';

/** The latest value of what `read` follows, renewed at most every eighth of a second. */
export function useThrottled<T>(read: () => T): T {
  // Not followed by the component itself, which would be rendered with every frame.
  const shown = useSignal<T>(untracked(read));
  const renew = useMemo(
    () =>
      throttled(RENEW_MS, (value: T) => {
        shown.value = value;
      }),
    [],
  );
  useSignalEffect(() => renew(read()));
  return shown.value;
}
