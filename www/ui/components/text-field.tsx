/** A field for a text, reported on change. */

import { useTyped } from './use-typed.ts';

export function TextField({
  value,
  onText,
  rows,
  ...rest
}: {
  value: string;
  onText: (text: string) => unknown;
  /** one line, if absent */
  rows?: number;
  id?: string;
  placeholder?: string;
  'aria-label'?: string;
}) {
  /** What comes meanwhile does not replace it. */
  const [typed, setTyped] = useTyped<string | null>(null);
  const field = {
    ...rest,
    value: typed ?? value,
    onInput: ({ currentTarget }: { currentTarget: { value: string } }) =>
      setTyped(currentTarget.value),
    onChange: ({ currentTarget }: { currentTarget: { value: string } }) => {
      setTyped(null);
      onText(currentTarget.value);
    },
    // There is no change if the same text is typed again.
    onBlur: () => setTyped(null),
  };
  return rows ? <textarea rows={rows} {...field} /> : <input type="text" {...field} />;
}
