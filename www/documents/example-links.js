/**
 * The address that opens an example, which is permanent; `share-link.js` reads it.
 * @param {string} id
 */
export const linkTo = (id) => `#example=${id}`;
