/** What happens once: things that a page has one of, and actions of which one is under way at a time. */

/**
 * Returns a function that makes something at its first call and returns the same at later ones. After a
 * promise that is rejected, the next call makes it anew.
 */
export function once<Arguments extends unknown[], Made>(
  make: (...values: Arguments) => Made,
): (...values: Arguments) => Made {
  let made: Made | undefined;
  const forget = () => {
    made = undefined;
  };
  return (...values) => {
    if (made !== undefined) return made;
    made = make(...values);
    if (made instanceof Promise) made.catch(forget);
    return made;
  };
}

/**
 * Returns the action so that each call begins after the one before has ended: a second press on what
 * opens and closes something closes it, although it was still being prepared.
 */
export function inTurn(action: () => unknown): () => unknown {
  let last: Promise<unknown> | null = null;
  return () => {
    const made = last ? last.then(action, action) : action();
    if (!(made instanceof Promise)) return made;
    const own = (last = made);
    const end = () => {
      if (last === own) last = null;
    };
    made.then(end, end);
    return made;
  };
}

/**
 * Returns the action without effect while its last promise is pending: what prepares a dialog and
 * opens it would open a second one at a second press.
 */
export function oneAtATime<Arguments extends unknown[], Made>(
  action: (...values: Arguments) => Made,
): (...values: Arguments) => Made | undefined {
  let isPending = false;
  const end = () => {
    isPending = false;
  };
  return (...values) => {
    if (isPending) return undefined;
    const made = action(...values);
    if (made instanceof Promise) {
      isPending = true;
      made.then(end, end);
    }
    return made;
  };
}
