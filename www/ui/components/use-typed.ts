/** Input that is not reported yet. */

import { createContext } from 'preact';
import { useContext, useState } from 'preact/hooks';

/** What the fields inside are about, such as the open model. */
export const Subject = createContext<unknown>(null);

/**
 * Returns what is typed, and sets it. When the field is about something else, it is forgotten: it was
 * not meant for that.
 * @param nothing stands for no input
 */
export function useTyped<Typed>(nothing: Typed): [Typed, (typed: Typed) => void] {
  const subject = useContext(Subject);
  const [now, set] = useState({ typed: nothing, subject });
  return [now.subject === subject ? now.typed : nothing, (typed) => set({ typed, subject })];
}
