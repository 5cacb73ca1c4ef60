/** Errors as one line for people. */

/**
 * How the messages of failed `import()`, `fetch` and streamed WebAssembly begin in Chromium, Firefox
 * and Safari. All are type errors.
 */
const NOT_FETCHED =
  /^(Failed to fetch( dynamically imported module: | \(|$)|error loading dynamically imported module\b|Importing a module script failed|NetworkError when attempting to fetch|Load failed( \(|$)|WebAssembly compilation aborted: Network error)/;
/** The same of the generated code that loads style sheets and modules of WebAssembly. */
const NOT_LOADED = /^(Unable to preload CSS for \S+$|failed to fetch Wasm: \d+ )/;

/**
 * Whether a part of the page could not be fetched. Other errors may have the same words in them, as
 * in the name of a file.
 */
const isNotFetched = (thrown: unknown, message: string) =>
  (thrown instanceof TypeError && NOT_FETCHED.test(message)) ||
  (thrown instanceof Error && NOT_LOADED.test(message));

/** Error of what the user has cancelled, or given up by opening another model: nothing to report. */
export class Cancelled extends Error {
  isDirect;

  /** @param isDirect false for what ended only because its worker had to end for something else */
  constructor(isDirect: boolean = true) {
    super('Cancelled.');
    this.isDirect = isDirect;
  }
}

/** Whether something ended only with what was cancelled: it can be asked for again. */
export const wasCollateral = (thrown: unknown) => thrown instanceof Cancelled && !thrown.isDirect;

/**
 * Asks once more if the first answer was cancelled with something else.
 * @param renew first makes again what the worker had
 */
export const retryIfCollateral = <Answer>(
  ask: () => Promise<Answer>,
  renew: () => unknown = () => {},
): Promise<Answer> =>
  ask().catch(async (thrown: unknown) => {
    if (!wasCollateral(thrown)) throw thrown;
    await renew();
    return ask();
  });

/** Returns a one-line message for any thrown value. */
export function messageOf(thrown: unknown): string {
  const hasMessage = thrown && typeof thrown === 'object' && 'message' in thrown;
  const message = String(hasMessage ? thrown.message : thrown);
  return isNotFetched(thrown, message)
    ? 'A part of the page could not be fetched. Check the network.'
    : message;
}

/**
 * Returns a sentence on a refusal with the engine's reason. Errors of the page are sentences already, on
 * what has happened instead.
 * @param words before the reason
 */
export function refusalOf(thrown: unknown, words: string): string {
  const message = messageOf(thrown);
  return message.endsWith('.') ? message : `${words}: ${message}.`;
}

/** Says which file could not be read: browsers say only why. */
export const unreadable =
  ({ name }: { name: string }) =>
  (thrown: unknown): never => {
    if (thrown instanceof Cancelled) throw thrown;
    throw new Error(`${name} could not be read from the disk (${messageOf(thrown)}).`);
  };

/**
 * Whether the wasm instance has trapped, which makes its state unusable. Other errors leave it
 * intact, including a RangeError of the page's own code; but one with wasm frames on its stack is
 * an overflow of the stack in wasm, or interrupted wasm in the middle of its work.
 */
export function isTrap(thrown: unknown) {
  if (thrown instanceof WebAssembly.RuntimeError) return true;
  return thrown instanceof RangeError && /\bwasm-function\b/.test(thrown.stack ?? '');
}
