/** Links that name an example: `#example=ID` behind the address of the page. They are permanent. */

const FORM = /^#example=([\w-]+)$/;

/**
 * The id that an address names, if it names an example.
 * @param {string} hash `location.hash`
 * @returns {string | null}
 */
export function exampleNamed(hash) {
  return FORM.exec(hash)?.[1] ?? null;
}

/** @param {string} id */
export const linkTo = (id) => `#example=${id}`;

/**
 * Puts what is open into the address, without a step of the browser's history; an address that says
 * something else stays.
 * @param {string | null} id none where what is open is no example
 */
export function nameInAddress(id) {
  const { hash, pathname, search } = location;
  if (id !== null) history.replaceState(history.state, '', linkTo(id));
  else if (exampleNamed(hash) !== null) {
    history.replaceState(history.state, '', pathname + search);
  }
}
